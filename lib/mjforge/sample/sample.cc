#include "mjforge/sample/sample.h"

#include <algorithm>

#include <fmt/format.h>

namespace mjforge::sample {
namespace {

using diag::Code;
using Overrides = Evaluator::Overrides;

// Whether values may differ from one attempt to the next.
class Redraw {
 public:
  // A sampler that knows the batch has settled the exact choices.
  explicit Redraw(const Sampler* sampler)
      : exact_is_settled_(sampler != nullptr && sampler->batch() > 0) {}

  bool Changes(const spec::Value& value) const {
    if (const auto* draw = std::get_if<spec::Draw>(&value.form)) {
      const bool settled = draw->rows != nullptr ||
                           draw->distribution == spec::Distribution::kCycle ||
                           (draw->exact && exact_is_settled_);
      return !settled || ChangesAny(draw->arguments);
    }
    if (const auto* list = std::get_if<spec::List>(&value.form)) return ChangesAny(list->items);
    if (const auto* color = std::get_if<spec::HsvColor>(&value.form)) {
      return ChangesAny(color->items);
    }
    if (const auto* each = std::get_if<spec::Each>(&value.form))
      return Changes(*each->value) || Changes(*each->count);
    return std::holds_alternative<spec::Arrangement>(value.form) ||
           std::holds_alternative<spec::RandomRotation>(value.form) ||
           std::holds_alternative<spec::RotationAbout>(value.form) ||
           std::holds_alternative<spec::PointOnSphere>(value.form);
  }

 private:
  bool ChangesAny(std::span<const spec::Value> values) const {
    return std::ranges::any_of(values, [this](const spec::Value& value) { return Changes(value); });
  }

  bool exact_is_settled_;
};

bool ParametersDraw(const Evaluator& evaluator, Overrides overrides) {
  const Redraw redraw(evaluator.sampler());
  return std::ranges::any_of(evaluator.spec().parameters, [&](const spec::Parameter& parameter) {
    const auto given = std::ranges::find(overrides, parameter.name,
                                         &std::pair<std::string, ParameterValue>::first);
    return given == overrides.end() && redraw.Changes(parameter.value);
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
        if (!ParametersDraw(evaluator_, overrides_)) {
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
    diag::Finding& finding = evaluator_.findings_->Add(
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

bool Evaluator::Sample(Overrides overrides) {
  return SampleShared(overrides) && Attempts(*this, overrides).Run();
}

std::optional<Evaluator> Sample(const spec::ObjectSpec& spec, DrawKey key, StreamId root,
                                Evaluator::Overrides overrides, diag::Findings& findings,
                                const Sampler* sampler) {
  std::optional<Evaluator> evaluator(std::in_place, spec, key, root, findings, sampler);
  if (!evaluator->Sample(overrides)) evaluator.reset();
  return evaluator;
}

}  // namespace mjforge::sample
