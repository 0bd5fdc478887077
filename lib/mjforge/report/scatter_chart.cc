// Scatter plot of mass against size.

#include <fmt/format.h>

#include <algorithm>

#include "mjforge/report/charts.h"

namespace mjforge::report {
namespace {

// Ratio of the largest to the smallest number on an axis above which the axis is logarithmic.
constexpr double kWide = 20;

Axis AxisOf(std::vector<double> values, double start, double end) {
  const auto [lo, hi] = std::minmax_element(values.begin(), values.end());
  const bool is_wide = *lo > 0 && *hi > kWide * *lo;
  Axis axis(is_wide ? Scale::kLogarithmic : Scale::kLinear, *lo, *hi, start, end);
  axis.Round(5);
  return axis;
}

std::string RangeText(std::vector<double> values, std::string_view unit) {
  const auto [lo, hi] = std::minmax_element(values.begin(), values.end());
  return fmt::format("{} to {} {}", ShortNumber(*lo), ShortNumber(*hi), unit);
}

}  // namespace

void AddScatter(Dictionary& parent, std::span<const Point> points, std::uint64_t all) {
  std::vector<double> sizes;
  std::vector<double> masses;
  for (const Point& point : points) {
    sizes.push_back(point.size);
    masses.push_back(point.mass);
  }
  const Axis x = AxisOf(sizes, kScatterArea.left, kScatterArea.right);
  const Axis y = AxisOf(masses, kScatterArea.bottom, kScatterArea.top);
  std::string good;
  std::string bad;
  for (const Point& point : points) {
    const double at_x = x.At(point.size);
    const double at_y = y.At(point.mass);
    if (point.is_bad) {
      bad += fmt::format("M{:.1f} {:.1f}l5 5m0 -5l-5 5", at_x - 2.5, at_y - 2.5);
    } else {
      good += fmt::format("M{:.1f} {:.1f}h0", at_x, at_y);
    }
  }
  Dictionary& chart = Include(parent, "SCATTER", TemplateName::kScatter);
  Set(chart, "TITLE", "Mass against size");
  Set(chart, "DESCRIPTION",
      fmt::format("{} of {}: size {}, mass {}", CountText(points.size()), CountText(all, "object"),
                  RangeText(sizes, "m"), RangeText(masses, "kg")));
  AddAxis(chart, "X", x.Ticks(5), "size, m");
  AddAxis(chart, "Y", y.Ticks(5), "mass, kg");
  Set(chart, "GOOD", good);
  if (!bad.empty()) Set(Section(chart, "BAD"), "PATH", bad);
}

}  // namespace mjforge::report
