#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mjforge/report/charts.h"

namespace mjforge::report {
namespace {

constexpr Frame kFrame = kHistogramFrame;

struct Layout {
  bool logarithmic = false;
  double lo = 0;  // of the bins; of logarithms where the axis is logarithmic
  double hi = 1;
  std::size_t bins = 1;
  const Histogram* drawn = nullptr;
  const Histogram* bad = nullptr;
  const Histogram* asked = nullptr;

  double Share(std::size_t bin) const {
    return static_cast<double>(bin) / static_cast<double>(bins);
  }
  // Where a bin begins, on the page.
  double Edge(std::size_t bin) const {
    return kFrame.left + Share(bin) * (kFrame.right - kFrame.left);
  }
  // The number at a place of the axis.
  double Value(double place) const { return logarithmic ? std::pow(10, place) : place; }
};

// Rice's rule, between what is too coarse for a shape and too fine for a phone.
std::size_t BinsFor(std::uint64_t count) {
  const double bins = 2 * std::cbrt(static_cast<double>(count));
  return static_cast<std::size_t>(std::clamp(std::round(bins), 5.0, 32.0));
}

// The range that what was asked for is worth showing on: without a long thin tail.
std::pair<double, double> Bulk(const Histogram& asked) {
  const double lo = asked.Quantile(0.001);
  const double hi = asked.Quantile(0.999);
  if (asked.max() - asked.min() < 1.5 * (hi - lo)) return {asked.min(), asked.max()};
  return {lo, hi};
}

Layout Lay(const HistogramChart& chart) {
  Layout layout;
  const Histogram& numbers = chart.drawn->all;
  layout.logarithmic = WantsLogarithm(numbers.min(), numbers.max(), numbers.Quantile(0.5));
  layout.drawn = layout.logarithmic ? &chart.drawn->log_all : &numbers;
  layout.bad = layout.logarithmic ? &chart.drawn->log_bad : &chart.drawn->bad;
  if (chart.asked != nullptr)
    layout.asked = layout.logarithmic ? &chart.asked->log_all : &chart.asked->all;
  layout.lo = layout.drawn->min();
  layout.hi = layout.drawn->max();
  if (layout.asked != nullptr && layout.asked->count() > 0) {
    const auto [lo, hi] = Bulk(*layout.asked);
    layout.lo = std::min(layout.lo, lo);
    layout.hi = std::max(layout.hi, hi);
  }
  layout.bins = BinsFor(numbers.count());
  if (chart.whole && !layout.logarithmic) {
    const double width = std::ceil((layout.hi - layout.lo + 1) / static_cast<double>(layout.bins));
    layout.bins = static_cast<std::size_t>(std::ceil((layout.hi - layout.lo + 1) / width));
    layout.lo -= 0.5;
    layout.hi = layout.lo + width * static_cast<double>(layout.bins);
  }
  return layout;
}

std::string EdgeText(const Layout& layout, std::size_t bin) {
  return Shown(layout.Value(layout.lo + layout.Share(bin) * (layout.hi - layout.lo)));
}

// How many of the drawn ones each bin would hold by the spec.
std::vector<double> Expected(const Layout& layout) {
  std::vector<double> expected;
  if (layout.asked == nullptr || layout.asked->count() == 0) return expected;
  const double scale =
      static_cast<double>(layout.drawn->count()) / static_cast<double>(layout.asked->count());
  for (const std::uint64_t count : layout.asked->Bins(layout.lo, layout.hi, layout.bins))
    expected.push_back(scale * static_cast<double>(count));
  return expected;
}

std::string Outline(const Layout& layout, const Axis& y, const std::vector<double>& expected) {
  std::string path = fmt::format("M{:.1f} {:.1f}", kFrame.left, kFrame.bottom);
  for (std::size_t i = 0; i < expected.size(); ++i)
    path += fmt::format("V{:.1f}H{:.1f}", y.At(expected[i]), layout.Edge(i + 1));
  return path + fmt::format("V{:.1f}", kFrame.bottom);
}

void AddColumns(Dictionary& dictionary, const Layout& layout, const Axis& y,
                const std::vector<std::uint64_t>& drawn) {
  const std::vector<std::uint64_t> bad = layout.bad->Bins(layout.lo, layout.hi, layout.bins);
  const auto rectangle = [&](Dictionary& bar, std::size_t bin, std::uint64_t count) {
    const double left = layout.Edge(bin) + 0.5;
    const double top = y.At(static_cast<double>(count));
    Set(bar, "X", left);
    Set(bar, "Y", top);
    Set(bar, "WIDTH", std::max(layout.Edge(bin + 1) - 0.5 - left, 1.0));
    Set(bar, "HEIGHT", kFrame.bottom - top);
  };
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i] == 0) continue;
    Dictionary& bar = Section(dictionary, "BAR");
    rectangle(bar, i, drawn[i]);
    Set(bar, "LABEL",
        fmt::format("{} to {}: {}{}", EdgeText(layout, i), EdgeText(layout, i + 1),
                    Counted(drawn[i]), bad[i] > 0 ? ", bad " + Counted(bad[i]) : ""));
    if (bad[i] > 0) rectangle(Section(bar, "BAD"), i, bad[i]);
  }
}

std::string Description(const HistogramChart& chart) {
  const Histogram& numbers = chart.drawn->all;
  std::string text =
      fmt::format("Histogram of {} from {} to {}, mean {}", Counted(numbers.count(), "value"),
                  Shown(numbers.min()), Shown(numbers.max()), Shown(numbers.mean()));
  if (chart.drawn->bad.count() > 0)
    text += fmt::format("; {} of variants that failed", Counted(chart.drawn->bad.count()));
  if (chart.asked != nullptr && chart.asked->all.count() > 0) {
    text += fmt::format(". Expected: {} to {}, mean {}", Shown(chart.asked->all.min()),
                        Shown(chart.asked->all.max()), Shown(chart.asked->all.mean()));
  }
  return text;
}

// Of counts: there is no half variant.
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
  const Layout layout = Lay(chart);
  const std::vector<std::uint64_t> drawn = layout.drawn->Bins(layout.lo, layout.hi, layout.bins);
  const std::vector<double> expected = Expected(layout);
  double most = static_cast<double>(*std::max_element(drawn.begin(), drawn.end()));
  for (const double count : expected) most = std::max(most, count);
  const Axis x(layout.logarithmic ? Scale::kLogarithmic : Scale::kLinear, layout.Value(layout.lo),
               layout.Value(layout.hi), kFrame.left, kFrame.right);
  Axis y(Scale::kLinear, 0, std::max(most, 1.0), kFrame.bottom, kFrame.top);
  y.Round(4);
  Dictionary& dictionary = Include(parent, "CHART", TemplateName::kHistogram);
  Set(dictionary, "ID", chart.id);
  Set(dictionary, "TITLE", chart.title);
  Set(dictionary, "DESCRIPTION", Description(chart));
  AddAxis(dictionary, "X", chart.whole ? WholeTicks(x, 5) : x.Ticks(5), chart.x_label);
  AddAxis(dictionary, "Y", WholeTicks(y, 4), "variants");
  AddColumns(dictionary, layout, y, drawn);
  if (!expected.empty()) Set(Section(dictionary, "ASKED"), "PATH", Outline(layout, y, expected));
}

}  // namespace mjforge::report
