// Sections of a report: findings, parameters, mass and size, physics.

#include "mjforge/report/page_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "mjforge/report/charts.h"
#include "mjforge/report/color_parameters.h"

namespace mjforge::report {
namespace {

// Maximum number of parameters on a page, and maximum number of charts for the components of a
// vector.
constexpr std::size_t kMaxParameters = 100;
constexpr std::size_t kMaxComponents = 6;

std::string_view MeaningOf(const std::string& code) {
  const diag::CodeInfo* found = diag::Find(diag::AllCodes(), code, &diag::CodeInfo::name);
  return found == nullptr ? std::string_view() : found->meaning;
}

void AddCode(Dictionary& list, const std::string& name, const CodeTally& tally,
             std::uint64_t variants) {
  Dictionary& code = Section(list, "CODE");
  const RecordedFinding& example = tally.example;
  const std::string share = ShareText(tally.variants, variants);
  Set(code, "NAME", Clean(name));
  Set(code, "MEANING", MeaningOf(name));
  Set(code, "SEVERITY", example.severity == "warning" ? "warning" : "error");
  Set(code, "VARIANTS", CountText(tally.variants));
  Set(code, "SHARE", share);
  Set(code, "PERCENT", 100 * Share(tally.variants, variants));
  ShowText(code, "PLACE", Clean(example.place));
  Set(code, "MESSAGE", Clean(example.message));
  ShowText(code, "HINT", Clean(example.hint));
  Set(code, "INDEX", fmt::format("{}", tally.index));
}

std::string StatisticsText(const Histogram& numbers) {
  return fmt::format("{} to {}, mean {}, std {}", ShortNumber(numbers.min()),
                     ShortNumber(numbers.max()), ShortNumber(numbers.mean()),
                     ShortNumber(numbers.StandardDeviation()));
}

bool IsConstant(const Histogram& numbers) { return numbers.min() == numbers.max(); }

// Adds a histogram and its statistics; only the value if all drawn and expected numbers are equal.
void AddNumbers(Dictionary& panel, HistogramChart chart) {
  const Histogram& numbers = chart.drawn->all;
  if (chart.expected != nullptr && chart.expected->all.count() == 0) chart.expected = nullptr;
  if (IsConstant(numbers) && (chart.expected == nullptr || IsConstant(chart.expected->all))) {
    ShowText(panel, "CONSTANT", ShortNumber(numbers.min()));
    return;
  }
  AddHistogram(panel, chart);
  ShowText(panel, "NOTE", StatisticsText(numbers));
}

// Adds the panels of one parameter: one panel, or one for each component of a vector. The first
// panel has the parameter's description.
class ParameterPanels {
 public:
  ParameterPanels(Dictionary& list, const Batch& batch, const ParameterTally& drawn,
                  std::size_t number)
      : list_(list),
        drawn_(drawn),
        expected_(batch.expected ? batch.expected->Find(drawn.name) : nullptr),
        declared_(ParameterOf(batch, drawn.name)),
        id_(fmt::format("parameter-{}", number)) {
    is_set_ = std::ranges::any_of(batch.summary.first->settings,
                                  [&](const auto& setting) { return setting.first == drawn.name; });
  }

  /// Adds the panels. `colors` has some of the drawn values if the parameter is a colour.
  void operator()(const std::vector<std::string>& colors) {
    const auto values = drawn_.Values();
    if (!values.empty()) return AddValues(values);
    const std::size_t count = drawn_.numbers.size();
    for (std::size_t i = 0; i < std::min(count, kMaxComponents); ++i) {
      Dictionary& panel = AddPanel(drawn_.NameOf(i), i == 0);
      if (i == 0) AddColors(panel, colors);
      const bool is_known = expected_ != nullptr && i < expected_->numbers.size();
      AddNumbers(panel, {fmt::format("{}-{}", id_, i), Title(), Unit(), &drawn_.numbers[i],
                         is_known ? &expected_->numbers[i] : nullptr});
    }
  }

 private:
  void AddValues(const std::vector<std::pair<std::string, Counts>>& values) {
    Dictionary& panel = AddPanel(drawn_.name, true);
    const auto expected = expected_ == nullptr ? decltype(drawn_.Values()){} : expected_->Values();
    if (values.size() == 1 && expected.size() <= 1) {
      ShowText(panel, "CONSTANT", Clean(values.front().first));
    } else {
      AddBars(panel, {id_, Title(), values, expected});
      if (drawn_.more_texts) {
        ShowText(panel, "NOTE",
                 fmt::format("Only the first {} different texts are shown.",
                             CountText(ParameterTally::kMaxTexts)));
      }
    }
  }

  static void AddColors(Dictionary& panel, const std::vector<std::string>& colors) {
    if (colors.empty()) return;
    Dictionary& shown = Section(panel, "COLORS");
    Set(shown, "COUNT", CountText(colors.size(), "variant"));
    for (const std::string& color : colors) ShowText(shown, "SWATCH", color);
  }

  Dictionary& AddPanel(const std::string& name, bool with_words) {
    Dictionary& panel = Section(list_, "PARAMETER");
    Set(panel, "NAME", Clean(name));
    ShowText(panel, "UNIT", Unit());
    if (declared_ == nullptr || !with_words) return panel;
    ShowText(panel, "DOC", Clean(declared_->doc));
    if (declared_->source.empty()) return panel;
    Dictionary& source = Section(panel, "SOURCE");
    Set(source, "TEXT", Clean(declared_->source));
    if (is_set_) Section(source, "IS_SET");
    return panel;
  }

  std::string Unit() const { return UnitText(declared_); }
  std::string Title() const {
    const std::string unit = Unit();
    return Clean(drawn_.name) + (unit.empty() ? "" : ", " + unit);
  }

  Dictionary& list_;
  const ParameterTally& drawn_;
  const ParameterTally* expected_;
  const spec::Parameter* declared_;
  std::string id_;
  bool is_set_ = false;
};

std::string WordsOf(const TestTally& test) {
  if (test.kind == TestTally::Kind::kGrasps) {
    return fmt::format("Jaws lift and hold it; {} of {} do.", CountText(test.held),
                       CountText(test.ways, "way"));
  }
  // In the order of Kind.
  constexpr std::array kWords = {
      "SimReady benchmark", "The balls that are dropped into it stay inside.",
      "All free bodies stay where they start.", "All that has to fit into holes goes in."};
  return kWords[static_cast<std::size_t>(test.kind)];
}

void AddTests(Dictionary& section, const TestTallies& tests) {
  if (tests.list().empty()) return;
  Dictionary& table = Section(section, "TRIALS");
  for (const TestTally& test : tests.list()) {
    Dictionary& row = Section(table, "TRIAL");
    const std::uint64_t all = test.passed + test.failed;
    Set(row, "NAME", test.name.empty() ? "grasp" : Clean(test.name));
    Set(row, "MEANING", WordsOf(test));
    Set(row, "PASSED", CountText(test.passed));
    Set(row, "FAILED", CountText(test.failed));
    Set(row, "SHARE", ShareText(test.passed, all));
    Set(row, "PERCENT", 100 * Share(test.passed, all));
  }
}

// Adds a panel for each measure that has values: measures of physics checks if `physics` is true,
// otherwise all other measures.
void AddMeasures(Dictionary& section, const ManifestSummary& summary, bool physics) {
  for (std::size_t i = 0; i < summary.measures.size(); ++i) {
    const Measure& measure = Measures()[i];
    const NumberTally& tally = summary.measures[i];
    if (measure.is_physics != physics || tally.all.count() == 0) continue;
    Dictionary& panel = Section(section, "MEASURE");
    const std::string title = measure.unit.empty()
                                  ? std::string(measure.title)
                                  : fmt::format("{}, {}", measure.title, measure.unit);
    Set(panel, "NAME", measure.title);
    ShowText(panel, "UNIT", measure.unit);
    Set(panel, "DOC", measure.doc);
    AddNumbers(panel, {fmt::format("measure-{}", i), title, std::string(measure.unit), &tally,
                       nullptr, measure.is_whole});
  }
}

}  // namespace

void AddFindings(Dictionary& body, const ManifestSummary& summary) {
  if (summary.codes.empty()) {
    Section(body, "NO_FINDINGS");
    return;
  }
  Dictionary& list = Section(body, "HAS_FINDINGS");
  std::vector<std::pair<std::string, const CodeTally*>> codes;
  for (const auto& [name, tally] : summary.codes) codes.emplace_back(name, &tally);
  // Sorts errors before warnings, and codes of equal severity by descending frequency.
  std::stable_sort(codes.begin(), codes.end(), [](const auto& a, const auto& b) {
    const bool a_warns = a.second->example.severity == "warning";
    const bool b_warns = b.second->example.severity == "warning";
    return a_warns != b_warns ? b_warns : a.second->variants > b.second->variants;
  });
  for (const auto& [name, tally] : codes) AddCode(list, name, *tally, summary.variants);
}

void AddParameterPanels(Dictionary& parent, const Batch& batch,
                        const std::function<bool(const ParameterTally&)>& is_shown) {
  const std::vector<ParameterTally>& drawn = batch.summary.params.list();
  Dictionary& list = Include(parent, "PANELS", TemplateName::kPanels);
  std::map<std::string, std::vector<std::string>> colors = DrawnColors(batch);
  for (std::size_t i = 0; i < std::min(drawn.size(), kMaxParameters); ++i) {
    if (is_shown(drawn[i])) ParameterPanels(list, batch, drawn[i], i)(colors[drawn[i].name]);
  }
}

void AddParameters(Dictionary& body, const Batch& batch) {
  const std::vector<ParameterTally>& drawn = batch.summary.params.list();
  if (drawn.empty()) return;
  Section(body, "PARAMETERS_LINK");
  Dictionary& section = Section(body, "PARAMETERS");
  if (batch.summary.statuses.ok < batch.summary.variants) Section(section, "ANY_BAD");
  if (batch.expected) Section(section, "ANY_EXPECTED");
  if (drawn.size() > kMaxParameters) {
    ShowText(
        section, "MORE",
        fmt::format("The first {} of {}.", kMaxParameters, CountText(drawn.size(), "parameter")));
  }
  AddParameterPanels(section, batch, [](const ParameterTally&) { return true; });
  ShowSpecText(section, batch.summary.first->spec, batch.spec_text);
}

void AddMassAndSize(Dictionary& body, const ManifestSummary& summary) {
  const std::uint64_t all = summary.points.seen();
  if (all == 0) return;
  Section(body, "MEASURES_LINK");
  Dictionary& section = Section(body, "MEASURES");
  const std::vector<Point> points = summary.points.Take(kMaxPoints);
  std::string text = points.size() < all
                         ? fmt::format("{} of {} are plotted, spread over the batch.",
                                       CountText(points.size()), CountText(all, "object"))
                         : fmt::format("{}.", CountText(all, "object"));
  if (std::ranges::any_of(points, &Point::is_bad)) text += "  Crosses mark variants that failed.";
  Set(section, "TEXT", text);
  AddScatter(section, points, all);
  AddMeasures(section, summary, false);
}

void AddPhysics(Dictionary& body, const ManifestSummary& summary) {
  if (!summary.HasPhysics()) return;
  const std::uint64_t measured = summary.Of(MeasureId::kContacts).all.count();
  Section(body, "PHYSICS_LINK");
  Dictionary& section = Section(body, "PHYSICS");
  const std::uint64_t dropped = summary.Of(MeasureId::kDrift).all.count();
  std::string text =
      dropped == 0
          ? std::string("These objects are fixed to the world, so none was dropped.")
          : fmt::format("{} dropped on a floor from 2 mm above it: {} came to rest.",
                        dropped == measured
                            ? fmt::format("Each of {} was", CountText(dropped))
                            : fmt::format("{} of {} were", CountText(dropped), CountText(measured)),
                        CountText(summary.Of(MeasureId::kTimeToRest).all.count()));
  if (summary.Of(MeasureId::kJointReach).all.count() > 0)
    text += " Each joint was driven to both ends of its range and back.";
  Set(section, "TEXT", text);
  if (dropped > 0) {
    Dictionary& sizes = Section(section, "SIZES");
    Set(sizes, "NCON", fmt::format("{:.0f}", summary.Of(MeasureId::kContacts).all.max()));
    Set(sizes, "NEFC", fmt::format("{:.0f}", summary.Of(MeasureId::kConstraints).all.max()));
  }
  AddTests(section, summary.tests);
  AddMeasures(section, summary, true);
}

}  // namespace mjforge::report
