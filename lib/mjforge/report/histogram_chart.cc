// Histogram charts: choice of the bins, bars for the drawn values, and the line of expected counts.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mjforge/report/charts.h"

namespace mjforge::report {
namespace {

constexpr PlotArea kArea = kHistogramArea;

struct Binning {
  bool logarithmic = false;
  double lo = 0;  // lower edge of the bins; a decimal logarithm if the axis is logarithmic
  double hi = 1;
  std::size_t bins = 1;
  const Histogram* drawn = nullptr;
  const Histogram* bad = nullptr;
  const Histogram* expected = nullptr;

  double Share(std::size_t bin) const {
    return static_cast<double>(bin) / static_cast<double>(bins);
  }
  // Returns the horizontal position of the left edge of a bin, in units of the SVG.
  double Edge(std::size_t bin) const {
    return kArea.left + Share(bin) * (kArea.right - kArea.left);
  }
  // Returns the value for a number from `lo` to `hi`, which may be the value's logarithm.
  double Value(double place) const { return logarithmic ? std::pow(10, place) : place; }
};

// Returns the number of bins for `count` values by Rice's rule, within limits for legible charts.
std::size_t BinsFor(std::uint64_t count) {
  const double bins = 2 * std::cbrt(static_cast<double>(count));
  return static_cast<std::size_t>(std::clamp(std::round(bins), 5.0, 32.0));
}

// Returns the range of the expected values; without the tails (0.1 % of the values at each end) if
// the tails take at least a third of the range.
std::pair<double, double> Bulk(const Histogram& expected) {
  const double lo = expected.Quantile(0.001);
  const double hi = expected.Quantile(0.999);
  if (expected.max() - expected.min() < 1.5 * (hi - lo)) return {expected.min(), expected.max()};
  return {lo, hi};
}

Binning MakeBinning(const HistogramChart& chart) {
  Binning binning;
  const Histogram& numbers = chart.drawn->all;
  binning.logarithmic = WantsLogarithm(numbers.min(), numbers.max(), numbers.Quantile(0.5));
  binning.drawn = binning.logarithmic ? &chart.drawn->log_all : &numbers;
  binning.bad = binning.logarithmic ? &chart.drawn->log_bad : &chart.drawn->bad;
  if (chart.expected != nullptr)
    binning.expected = binning.logarithmic ? &chart.expected->log_all : &chart.expected->all;
  binning.lo = binning.drawn->min();
  binning.hi = binning.drawn->max();
  if (binning.expected != nullptr && binning.expected->count() > 0) {
    const auto [lo, hi] = Bulk(*binning.expected);
    binning.lo = std::min(binning.lo, lo);
    binning.hi = std::max(binning.hi, hi);
  }
  binning.bins = BinsFor(numbers.count());
  if (chart.whole && !binning.logarithmic) {
    const double width =
        std::ceil((binning.hi - binning.lo + 1) / static_cast<double>(binning.bins));
    binning.bins = static_cast<std::size_t>(std::ceil((binning.hi - binning.lo + 1) / width));
    binning.lo -= 0.5;
    binning.hi = binning.lo + width * static_cast<double>(binning.bins);
  }
  return binning;
}

std::string EdgeText(const Binning& binning, std::size_t bin) {
  return ShortNumber(binning.Value(binning.lo + binning.Share(bin) * (binning.hi - binning.lo)));
}

// Returns the expected count of each bin, scaled to the number of drawn values; an empty list if no
// expected values are known.
std::vector<double> ExpectedCounts(const Binning& binning) {
  std::vector<double> curve;
  if (binning.expected == nullptr || binning.expected->count() == 0) return curve;
  const double scale =
      static_cast<double>(binning.drawn->count()) / static_cast<double>(binning.expected->count());
  for (const std::uint64_t count : binning.expected->Bins(binning.lo, binning.hi, binning.bins))
    curve.push_back(scale * static_cast<double>(count));
  return curve;
}

std::string Outline(const Binning& binning, const Axis& y, const std::vector<double>& curve) {
  std::string path = fmt::format("M{:.1f} {:.1f}", kArea.left, kArea.bottom);
  for (std::size_t i = 0; i < curve.size(); ++i)
    path += fmt::format("V{:.1f}H{:.1f}", y.At(curve[i]), binning.Edge(i + 1));
  return path + fmt::format("V{:.1f}", kArea.bottom);
}

void AddColumns(Dictionary& dictionary, const Binning& binning, const Axis& y,
                const std::vector<std::uint64_t>& drawn) {
  const std::vector<std::uint64_t> bad = binning.bad->Bins(binning.lo, binning.hi, binning.bins);
  const auto rectangle = [&](Dictionary& bar, std::size_t bin, std::uint64_t count) {
    const double left = binning.Edge(bin) + 0.5;
    const double top = y.At(static_cast<double>(count));
    Set(bar, "X", left);
    Set(bar, "Y", top);
    Set(bar, "WIDTH", std::max(binning.Edge(bin + 1) - 0.5 - left, 1.0));
    Set(bar, "HEIGHT", kArea.bottom - top);
  };
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i] == 0) continue;
    Dictionary& bar = Section(dictionary, "BAR");
    rectangle(bar, i, drawn[i]);
    Set(bar, "LABEL",
        fmt::format("{} to {}: {}{}", EdgeText(binning, i), EdgeText(binning, i + 1),
                    CountText(drawn[i]), bad[i] > 0 ? ", bad " + CountText(bad[i]) : ""));
    if (bad[i] > 0) rectangle(Section(bar, "BAD"), i, bad[i]);
  }
}

std::string Description(const HistogramChart& chart) {
  const Histogram& numbers = chart.drawn->all;
  std::string text = fmt::format("Histogram of {} from {} to {}, mean {}",
                                 CountText(numbers.count(), "value"), ShortNumber(numbers.min()),
                                 ShortNumber(numbers.max()), ShortNumber(numbers.mean()));
  if (chart.drawn->bad.count() > 0)
    text += fmt::format("; {} of variants that failed", CountText(chart.drawn->bad.count()));
  if (chart.expected != nullptr && chart.expected->all.count() > 0) {
    text += fmt::format(". Expected: {} to {}, mean {}", ShortNumber(chart.expected->all.min()),
                        ShortNumber(chart.expected->all.max()),
                        ShortNumber(chart.expected->all.mean()));
  }
  return text;
}

// Returns those ticks of an axis that are at whole numbers, for counts and whole values.
std::vector<Axis::Tick> WholeTicks(const Axis& axis, int count) {
  std::vector<Axis::Tick> ticks = axis.Ticks(count);
  std::erase_if(ticks,
                [](const Axis::Tick& tick) { return tick.label.find('.') != tick.label.npos; });
  return ticks;
}

}  // namespace

void AddAxis(Dictionary& chart, const std::string& axis, const std::vector<Axis::Tick>& ticks,
             std::string_view label) {
  for (const Axis::Tick& tick : ticks) {
    Dictionary& place = Section(chart, (axis + "_TICK").c_str());
    Set(place, "AT", tick.at);
    Set(place, "LABEL", tick.label);
  }
  Set(chart, (axis + "_LABEL").c_str(), label);
}

void AddHistogram(Dictionary& parent, const HistogramChart& chart) {
  const Binning binning = MakeBinning(chart);
  const std::vector<std::uint64_t> drawn =
      binning.drawn->Bins(binning.lo, binning.hi, binning.bins);
  const std::vector<double> curve = ExpectedCounts(binning);
  double most = static_cast<double>(*std::max_element(drawn.begin(), drawn.end()));
  for (const double count : curve) most = std::max(most, count);
  const Axis x(binning.logarithmic ? Scale::kLogarithmic : Scale::kLinear,
               binning.Value(binning.lo), binning.Value(binning.hi), kArea.left, kArea.right);
  Axis y(Scale::kLinear, 0, std::max(most, 1.0), kArea.bottom, kArea.top);
  y.Round(4);
  Dictionary& dictionary = Include(parent, "CHART", TemplateName::kHistogram);
  Set(dictionary, "ID", chart.id);
  Set(dictionary, "TITLE", chart.title);
  Set(dictionary, "DESCRIPTION", Description(chart));
  AddAxis(dictionary, "X", chart.whole ? WholeTicks(x, 5) : x.Ticks(5), chart.x_label);
  AddAxis(dictionary, "Y", WholeTicks(y, 4), "variants");
  AddColumns(dictionary, binning, y, drawn);
  if (!curve.empty()) Set(Section(dictionary, "EXPECTED"), "PATH", Outline(binning, y, curve));
}

}  // namespace mjforge::report
