// Bar charts: a horizontal bar for each value of a parameter.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "mjforge/report/charts.h"

namespace mjforge::report {
namespace {

constexpr double kRow = 22;  // distance from row to row, units of the SVG
constexpr double kBar = 14;  // height of a bar; must match bars.html
constexpr std::size_t kMaxRows = ParameterTally::kMaxWhole;
// Largest length of a label, bytes. Labels must fit to the left of the bars.
constexpr std::size_t kLabelBytes = 17;

struct Row {
  std::string value;
  Counts drawn;
  std::uint64_t expected = 0;
};

std::uint64_t Total(const std::vector<std::pair<std::string, Counts>>& values) {
  std::uint64_t total = 0;
  for (const auto& [value, counts] : values) total += counts.all;
  return total;
}

// Returns a row for each value: first the expected values, then drawn values that were not
// expected. If there are more than kMaxRows values, the last row sums up the least frequent values.
std::vector<Row> RowsOf(const BarChart& chart) {
  std::vector<Row> rows;
  std::map<std::string, std::size_t> places;
  const auto row_of = [&](const std::string& value) -> Row& {
    const auto [place, is_new] = places.emplace(value, rows.size());
    if (is_new) rows.push_back({value, {}, 0});
    return rows[place->second];
  };
  for (const auto& [value, counts] : chart.expected) row_of(value).expected = counts.all;
  for (const auto& [value, counts] : chart.drawn) row_of(value).drawn = counts;
  if (rows.size() <= kMaxRows) return rows;
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.drawn.all > b.drawn.all; });
  Row others{fmt::format("{} others", CountText(rows.size() - kMaxRows + 1)), {}, 0};
  for (std::size_t i = kMaxRows - 1; i < rows.size(); ++i) {
    others.drawn.all += rows[i].drawn.all;
    others.drawn.bad += rows[i].drawn.bad;
    others.expected += rows[i].expected;
  }
  rows.resize(kMaxRows - 1);
  rows.push_back(std::move(others));
  return rows;
}

// Total numbers of drawn and expected values, and the largest share of a single value in these.
struct Totals {
  std::uint64_t drawn = 0;
  std::uint64_t expected = 0;
  double most = 1e-9;

  double Width(std::uint64_t part, std::uint64_t whole) const {
    return Share(part, whole) / most * (kBarArea.right - kBarArea.left);
  }
};

Totals TotalsOf(const BarChart& chart, const std::vector<Row>& rows) {
  Totals totals{.drawn = Total(chart.drawn), .expected = Total(chart.expected)};
  for (const Row& row : rows) {
    totals.most = std::max(
        {totals.most, Share(row.drawn.all, totals.drawn), Share(row.expected, totals.expected)});
  }
  return totals;
}

std::string TextOf(const Row& row, const Totals& totals) {
  std::string text = fmt::format("{}: {} ({})", Clean(row.value, 80),
                                 ShareText(row.drawn.all, totals.drawn), CountText(row.drawn.all));
  if (totals.expected > 0)
    text += fmt::format(", expected {}", ShareText(row.expected, totals.expected));
  return text;
}

void AddRow(Dictionary& dictionary, const Row& row, const Totals& totals, double top) {
  Dictionary& shown = Section(dictionary, "ROW");
  Set(shown, "LABEL", Clean(row.value, kLabelBytes));
  Set(shown, "WHOLE_LABEL", TextOf(row, totals));
  Set(shown, "NUMBER", ShareText(row.drawn.all, totals.drawn));
  Set(shown, "TOP", top);
  Set(shown, "MIDDLE", top + kBar / 2);
  Set(shown, "WIDTH", totals.Width(row.drawn.all, totals.drawn));
  if (row.drawn.bad > 0) {
    Dictionary& bad = Section(shown, "BAD");
    Set(bad, "TOP", top);
    Set(bad, "WIDTH", totals.Width(row.drawn.bad, totals.drawn));
  }
  if (totals.expected > 0) {
    Set(Section(shown, "EXPECTED"), "PATH",
        fmt::format("M{} {:.1f}H{:.1f}v{}H{}", kBarArea.left, top - 1.5,
                    kBarArea.left + totals.Width(row.expected, totals.expected), kBar + 3,
                    kBarArea.left));
  }
}

}  // namespace

void AddBars(Dictionary& parent, const BarChart& chart) {
  const std::vector<Row> rows = RowsOf(chart);
  const Totals totals = TotalsOf(chart, rows);
  Dictionary& dictionary = Include(parent, "CHART", TemplateName::kBars);
  std::string description;
  double top = kBarArea.top;
  for (const Row& row : rows) {
    AddRow(dictionary, row, totals, top);
    description += (description.empty() ? "" : "; ") + TextOf(row, totals);
    top += kRow;
  }
  Set(dictionary, "ID", chart.id);
  Set(dictionary, "TITLE", chart.title);
  Set(dictionary, "DESCRIPTION", description);
  Set(dictionary, "HEIGHT", top);
  Set(dictionary, "BOTTOM", top - 2);
}

}  // namespace mjforge::report
