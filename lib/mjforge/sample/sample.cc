#include "mjforge/sample/sample.h"

#include <algorithm>

#include <fmt/format.h>

namespace mjforge::sample {
namespace {

using diag::Code;
using Overrides = std::span<const std::pair<std::string, ParameterValue>>;

bool Draws(const spec::Value& value);

bool AnyDraws(std::span<const spec::Value> values) { return std::ranges::any_of(values, Draws); }

// Whether the value may differ from one attempt to the next. (A cycle does not.)
bool Draws(const spec::Value& value) {
  if (const auto* draw = std::get_if<spec::Draw>(&value.form)) {
    return draw->distribution != spec::Distribution::kCycle || AnyDraws(draw->arguments);
  }
  if (const auto* list = std::get_if<spec::List>(&value.form)) return AnyDraws(list->items);
  if (const auto* color = std::get_if<spec::HsvColor>(&value.form)) return AnyDraws(color->items);
  return std::holds_alternative<spec::RandomRotation>(value.form) ||
         std::holds_alternative<spec::RotationAbout>(value.form) ||
         std::holds_alternative<spec::PointOnSphere>(value.form);
}

bool ParametersDraw(const spec::ObjectSpec& spec, Overrides overrides) {
  return std::ranges::any_of(spec.parameters, [&](const spec::Parameter& parameter) {
    const auto given = std::ranges::find(overrides, parameter.name,
                                         &std::pair<std::string, ParameterValue>::first);
    return given == overrides.end() && Draws(parameter.value);
  });
}

}  // namespace

// The attempts at one variant, and what each requirement rejected.
class Attempts {
 public:
  Attempts(Evaluator& evaluator, Overrides overrides)
      : evaluator_(evaluator), overrides_(overrides) {}

  // Whether some attempt met all requirements.
  bool Run() {
    const auto& requirements = evaluator_.spec_.requirements;
    for (std::uint64_t count = 0; count < kMaxAttempts; ++count, ++evaluator_.key_.attempt) {
      if (evaluator_.SampleParameters(overrides_)) return true;
      if (evaluator_.failed_) return false;
      if (count == 0) {
        if (!ParametersDraw(evaluator_.spec_, overrides_)) {
          ReportHopeless();
          return false;
        }
        rejected_.resize(requirements.size());
      }
      ++rejected_[static_cast<std::size_t>(evaluator_.rejected_by_)];
    }
    ReportTooMany();
    return false;
  }

 private:
  // Nothing is drawn: every attempt would be the same.
  void ReportHopeless() {
    const auto position = static_cast<std::size_t>(evaluator_.rejected_by_);
    const spec::Requirement& requirement = evaluator_.spec_.requirements[position];
    const std::string inputs = evaluator_.InputsText(requirement.expression);
    evaluator_.Fail(Code::kSampleRejected, requirement.mark,
                    fmt::format("requirement '{}' does not hold{}{}", requirement.expression.text(),
                                inputs.empty() ? "" : ": ", inputs),
                    "no parameter is drawn, so a redraw cannot help");
  }

  void ReportTooMany() {
    const auto& requirements = evaluator_.spec_.requirements;
    const auto worst = std::ranges::max_element(rejected_) - rejected_.begin();
    std::vector<diag::Note> notes;
    for (std::size_t i = 0; i < requirements.size(); ++i) {
      notes.push_back({requirements[i].mark,
                       fmt::format("'{}' rejected {} {}", requirements[i].expression.text(),
                                   rejected_[i], rejected_[i] == 1 ? "time" : "times")});
    }
    diag::Finding& finding = evaluator_.findings_.Add(
        Code::kSampleRejected, requirements[static_cast<std::size_t>(worst)].mark,
        fmt::format("no draw in {} attempts met all requirements", kMaxAttempts),
        "loosen a requirement, or narrow the ranges it compares");
    finding.notes = std::move(notes);
    finding.seed = evaluator_.key_.seed;
    finding.index = evaluator_.key_.index;
    evaluator_.failed_ = true;
  }

  Evaluator& evaluator_;
  Overrides overrides_;
  std::vector<std::uint64_t> rejected_;  // by requirement
};

std::optional<Evaluator> Sample(const spec::ObjectSpec& spec, DrawKey key, StreamId root,
                                Overrides overrides, diag::Findings& findings) {
  std::optional<Evaluator> evaluator(std::in_place, spec, key, root, findings);
  if (!Attempts(*evaluator, overrides).Run()) evaluator.reset();
  return evaluator;
}

}  // namespace mjforge::sample
