// Charts of a report or gallery: histograms, bar charts and a scatter plot, as SVG that is 360
// units wide.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/report/axis.h"
#include "mjforge/report/manifest_summary.h"
#include "mjforge/report/tallies.h"
#include "mjforge/report/templates.h"

namespace mjforge::report {

/// Edges of a chart's plot area, in units of the SVG; must match the chart's template.
struct PlotArea {
  double left = 46;
  double right = 350;
  double top = 18;
  double bottom = 160;
};
inline constexpr PlotArea kHistogramArea;
inline constexpr PlotArea kScatterArea = {.bottom = 220};
inline constexpr PlotArea kBarArea = {.left = 120, .right = 300, .top = 4};

/// Fills in the ticks and the label of an axis in the template of a chart. If `axis` is "X", fills
/// in a section X_TICK with AT and LABEL for each tick, and X_LABEL; if it is "Y", Y_TICK and
/// Y_LABEL.
void AddAxis(Dictionary& chart, const std::string& axis, const std::vector<Axis::Tick>& ticks,
             std::string_view label);

struct HistogramChart {
  std::string id;       // unique in the page
  std::string title;    // "handle_length, m"
  std::string x_label;  // "m"
  const NumberTally* drawn = nullptr;
  const NumberTally* expected = nullptr;  // null: the distribution is not known
  bool whole = false;  // true: the values are whole numbers; bins end halfway between these
};
/// Adds a histogram to the template `parent`: bars for the drawn values, with a mark for the share
/// of failed variants, and a line for the expected values, scaled to the number of drawn values.
void AddHistogram(Dictionary& parent, const HistogramChart& chart);

struct BarChart {
  std::string id;
  std::string title;
  std::vector<std::pair<std::string, Counts>> drawn;
  std::vector<std::pair<std::string, Counts>> expected;  // empty: the distribution is not known
};
/// Adds a bar chart to the template `parent`, with a bar for each value that was drawn or expected.
/// If there are too many values, only the most frequent ones get a bar.
void AddBars(Dictionary& parent, const BarChart& chart);

/// Adds a scatter plot of mass against size. `points` is a sample of objects, and must not be
/// empty; `all` is the number of all objects.
void AddScatter(Dictionary& parent, std::span<const Point> points, std::uint64_t all);

}  // namespace mjforge::report
