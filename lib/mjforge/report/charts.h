#pragma once

// The charts of a page: numbers -> places on an SVG 360 units wide.

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/report/axis.h"
#include "mjforge/report/gather.h"
#include "mjforge/report/tallies.h"
#include "mjforge/report/templates.h"

namespace mjforge::report {

/// Edges of a chart's plot area, in units of the SVG. Must match the chart's template.
struct Frame {
  double left = 46;
  double right = 350;
  double top = 18;
  double bottom = 160;
};
inline constexpr Frame kHistogramFrame;
inline constexpr Frame kScatterFrame = {.bottom = 220};
inline constexpr Frame kBarFrame = {.left = 120, .right = 300, .top = 4};

/// Fills in an axis: AXIS_TICK sections with AT and LABEL, and AXIS_LABEL, where `axis` is X or Y.
void AddAxis(Dictionary& chart, const std::string& axis, const std::vector<Axis::Tick>& ticks,
             std::string_view label);

struct HistogramChart {
  std::string id;       // of the page's elements; no two the same
  std::string title;    // "handle_length, m"
  std::string x_label;  // "m"
  const NumberTally* drawn = nullptr;
  const NumberTally* asked = nullptr;  // null: not known
  bool whole = false;                  // all numbers are: a bin begins and ends between two
};
/// Bars for what was drawn, with the bad variants marked in them, and a line for what the spec asks
/// for, scaled to the same total.
void AddHistogram(Dictionary& parent, const HistogramChart& chart);

struct BarChart {
  std::string id;
  std::string title;
  std::vector<std::pair<std::string, Counts>> drawn;
  std::vector<std::pair<std::string, Counts>> asked;  // empty: not known
};
/// A row for each value that was drawn or asked for; if there are very many, for the most frequent.
void AddBars(Dictionary& parent, const BarChart& chart);

/// Mass against size.
void AddScatter(Dictionary& parent, std::span<const Point> points, std::uint64_t all);

}  // namespace mjforge::report
