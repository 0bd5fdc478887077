#include "mjforge/report/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mjforge/report/charts.h"

namespace mjforge::report {
namespace {

// A page has room for so many charts.
constexpr std::size_t kMaxParameters = 100;
constexpr std::size_t kMaxComponents = 6;

std::string_view MeaningOf(const std::string& code) {
  const auto codes = diag::AllCodes();
  const auto found = std::ranges::find(codes, code, &diag::CodeInfo::name);
  return found == codes.end() ? std::string_view() : found->meaning;
}

void AddCode(Dictionary& list, const std::string& name, const CodeTally& tally,
             std::uint64_t variants) {
  Dictionary& code = Section(list, "CODE");
  const RecordedFinding& example = tally.example;
  const std::string share = ShareText(tally.variants, variants);
  Set(code, "NAME", Clean(name));
  Set(code, "MEANING", MeaningOf(name));
  Set(code, "SEVERITY", example.severity == "warning" ? "warning" : "error");
  Set(code, "VARIANTS", Counted(tally.variants));
  Set(code, "SHARE", share);
  Set(code, "PERCENT", 100 * static_cast<double>(tally.variants) / static_cast<double>(variants));
  ShowText(code, "PLACE", Clean(example.place));
  Set(code, "MESSAGE", Clean(example.message));
  ShowText(code, "HINT", Clean(example.hint));
  Set(code, "INDEX", fmt::format("{}", tally.index));
}

std::string StatisticsText(const Histogram& numbers) {
  return fmt::format("{} to {}, mean {}, std {}", Shown(numbers.min()), Shown(numbers.max()),
                     Shown(numbers.mean()), Shown(numbers.StandardDeviation()));
}

bool IsConstant(const Histogram& numbers) { return numbers.min() == numbers.max(); }

// A histogram and what it adds up to, or the one value.
void AddNumbers(Dictionary& panel, HistogramChart chart) {
  const Histogram& numbers = chart.drawn->all;
  if (chart.asked != nullptr && chart.asked->all.count() == 0) chart.asked = nullptr;
  if (IsConstant(numbers) && (chart.asked == nullptr || IsConstant(chart.asked->all))) {
    ShowText(panel, "CONSTANT", Shown(numbers.min()));
    return;
  }
  AddHistogram(panel, chart);
  ShowText(panel, "NOTE", StatisticsText(numbers));
}

std::string ComponentName(std::size_t i, std::size_t count) {
  constexpr std::array kNames = {"x", "y", "z", "w"};
  return count <= kNames.size() ? std::string(kNames[i]) : fmt::format("{}", i);
}

// Panels of one parameter: the first has its words.
class ParameterPanels {
 public:
  ParameterPanels(Dictionary& list, const Batch& batch, const ParameterTally& drawn,
                  std::size_t number)
      : list_(list),
        drawn_(drawn),
        asked_(batch.asked ? batch.asked->Find(drawn.name) : nullptr),
        declared_(ParameterOf(batch, drawn.name)),
        id_(fmt::format("parameter-{}", number)) {
    const auto& settings = batch.gathered.first->settings;
    is_set_ = std::any_of(settings.begin(), settings.end(),
                          [&](const auto& setting) { return setting.first == drawn.name; });
  }

  void operator()() {
    const auto values = drawn_.Values();
    if (!values.empty()) {
      AddValues(values);
      return;
    }
    const std::size_t count = drawn_.numbers.size();
    for (std::size_t i = 0; i < std::min(count, kMaxComponents); ++i) {
      Dictionary& panel = AddPanel(count == 1 ? "" : "." + ComponentName(i, count), i == 0);
      const bool is_known = asked_ != nullptr && i < asked_->numbers.size();
      AddNumbers(panel, {fmt::format("{}-{}", id_, i), Title(), Unit(), &drawn_.numbers[i],
                         is_known ? &asked_->numbers[i] : nullptr});
    }
  }

 private:
  void AddValues(const std::vector<std::pair<std::string, Counts>>& values) {
    Dictionary& panel = AddPanel("", true);
    const auto asked = asked_ == nullptr ? decltype(drawn_.Values()){} : asked_->Values();
    if (values.size() == 1 && asked.size() <= 1) {
      ShowText(panel, "CONSTANT", Clean(values.front().first));
    } else {
      AddBars(panel, {id_, Title(), values, asked});
      if (drawn_.more_texts) {
        ShowText(panel, "NOTE",
                 fmt::format("Only the first {} different texts are shown.",
                             Counted(ParameterTally::kMaxTexts)));
      }
    }
  }

  Dictionary& AddPanel(const std::string& component, bool with_words) {
    Dictionary& panel = Section(list_, "PARAMETER");
    Set(panel, "NAME", Clean(drawn_.name + component));
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
  const ParameterTally* asked_;
  const spec::Parameter* declared_;
  std::string id_;
  bool is_set_ = false;
};

std::string WordsOf(const Trial& trial) {
  switch (trial.kind) {
    case Trial::Kind::kSimReady:
      return "SimReady benchmark";
    case Trial::Kind::kHolds:
      return "The balls that are dropped into it stay inside.";
    case Trial::Kind::kFits:
      return "All that has to fit into holes goes in.";
    case Trial::Kind::kGrasps:
      return fmt::format("Jaws lift and hold it; {} of {} do.", Counted(trial.held),
                         Counted(trial.ways, "way"));
  }
  return {};
}

void AddTrials(Dictionary& section, const Trials& trials) {
  if (trials.list().empty()) return;
  Dictionary& table = Section(section, "TRIALS");
  for (const Trial& trial : trials.list()) {
    Dictionary& row = Section(table, "TRIAL");
    const std::uint64_t all = trial.passed + trial.failed;
    Set(row, "NAME", trial.name.empty() ? "grasp" : Clean(trial.name));
    Set(row, "MEANING", WordsOf(trial));
    Set(row, "PASSED", Counted(trial.passed));
    Set(row, "FAILED", Counted(trial.failed));
    Set(row, "SHARE", ShareText(trial.passed, all));
    Set(row, "PERCENT", 100 * static_cast<double>(trial.passed) / static_cast<double>(all));
  }
}

// Measures that belong together, but for those that nothing was measured of.
void AddMeasures(Dictionary& section, const Gathered& gathered, bool physics) {
  for (std::size_t i = 0; i < gathered.measures.size(); ++i) {
    const Measure& measure = Measures()[i];
    const NumberTally& tally = gathered.measures[i];
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

void AddFindings(Dictionary& body, const Gathered& gathered) {
  if (gathered.codes.empty()) {
    Section(body, "NO_FINDINGS");
    return;
  }
  Dictionary& list = Section(body, "HAS_FINDINGS");
  std::vector<std::pair<std::string, const CodeTally*>> codes;
  for (const auto& [name, tally] : gathered.codes) codes.emplace_back(name, &tally);
  // Errors first, then the most frequent.
  std::stable_sort(codes.begin(), codes.end(), [](const auto& a, const auto& b) {
    const bool a_warns = a.second->example.severity == "warning";
    const bool b_warns = b.second->example.severity == "warning";
    return a_warns != b_warns ? b_warns : a.second->variants > b.second->variants;
  });
  for (const auto& [name, tally] : codes) AddCode(list, name, *tally, gathered.variants);
}

void AddParameters(Dictionary& body, const Batch& batch) {
  const std::vector<ParameterTally>& drawn = batch.gathered.params.list();
  if (drawn.empty()) return;
  Section(body, "PARAMETERS_LINK");
  Dictionary& section = Section(body, "PARAMETERS");
  if (batch.gathered.statuses.ok < batch.gathered.variants) Section(section, "ANY_BAD");
  if (batch.asked) Section(section, "ANY_ASKED");
  if (drawn.size() > kMaxParameters) {
    ShowText(
        section, "MORE",
        fmt::format("The first {} of {}.", kMaxParameters, Counted(drawn.size(), "parameter")));
  }
  for (std::size_t i = 0; i < std::min(drawn.size(), kMaxParameters); ++i)
    ParameterPanels(section, batch, drawn[i], i)();
  if (batch.spec_text.empty()) return;
  Dictionary& text = Section(section, "SPEC_TEXT");
  Set(text, "FILE", Clean(batch.gathered.first->spec));
  Set(text, "TEXT", batch.spec_text);
}

void AddMassAndSize(Dictionary& body, const Gathered& gathered) {
  const std::uint64_t all = gathered.points.seen();
  if (all == 0) return;
  Section(body, "MEASURES_LINK");
  Dictionary& section = Section(body, "MEASURES");
  const std::vector<Point> points = gathered.points.Take(kMaxPoints);
  std::string text = points.size() < all
                         ? fmt::format("{} of {} are plotted, spread over the batch.",
                                       Counted(points.size()), Counted(all, "object"))
                         : fmt::format("{}.", Counted(all, "object"));
  if (std::any_of(points.begin(), points.end(), [](const Point& point) { return point.is_bad; }))
    text += "  Crosses mark variants that failed.";
  Set(section, "TEXT", text);
  AddScatter(section, points, all);
  AddMeasures(section, gathered, false);
}

void AddPhysics(Dictionary& body, const Gathered& gathered) {
  if (!gathered.HasPhysics()) return;
  const std::uint64_t measured = gathered.Of(MeasureId::kContacts).all.count();
  Section(body, "PHYSICS_LINK");
  Dictionary& section = Section(body, "PHYSICS");
  const std::uint64_t dropped = gathered.Of(MeasureId::kDrift).all.count();
  std::string text =
      dropped == 0
          ? std::string("These objects are fixed to the world, so none was dropped.")
          : fmt::format("{} dropped on a floor from 2 mm above it: {} came to rest.",
                        dropped == measured
                            ? fmt::format("Each of {} was", Counted(dropped))
                            : fmt::format("{} of {} were", Counted(dropped), Counted(measured)),
                        Counted(gathered.Of(MeasureId::kTimeToRest).all.count()));
  if (gathered.Of(MeasureId::kJointReach).all.count() > 0)
    text += " Each joint was driven to both ends of its range and back.";
  Set(section, "TEXT", text);
  if (dropped > 0) {
    Dictionary& sizes = Section(section, "SIZES");
    Set(sizes, "NCON", fmt::format("{:.0f}", gathered.Of(MeasureId::kContacts).all.max()));
    Set(sizes, "NEFC", fmt::format("{:.0f}", gathered.Of(MeasureId::kConstraints).all.max()));
  }
  AddTrials(section, gathered.trials);
  AddMeasures(section, gathered, true);
}

}  // namespace mjforge::report
