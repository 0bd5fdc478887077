// Rejection sampling: draws the parameters until they meet the requirements of the spec.

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

using diag::Code;
using Overrides = Evaluator::Overrides;

const ParameterValue* FindOverride(Overrides overrides, const spec::Parameter& parameter) {
  const auto found =
      std::ranges::find(overrides, parameter.name, &std::pair<std::string, ParameterValue>::first);
  return found == overrides.end() ? nullptr : &found->second;
}

bool AnyChanges(std::span<const spec::Value> values, bool is_planned);

// Returns true if a redraw can change the value. If `is_planned` is true, exact choices
// (`exact: true`) are distributed over the batch, so that a redraw does not change them.
bool Changes(const spec::Value& value, bool is_planned) {
  if (const auto* draw = std::get_if<spec::Draw>(&value.form)) {
    const bool is_fixed = draw->rows != nullptr ||
                          draw->distribution == spec::Distribution::kCycle ||
                          (draw->exact && is_planned);
    return !is_fixed || AnyChanges(draw->arguments, is_planned);
  }
  if (const auto* list = std::get_if<spec::List>(&value.form))
    return AnyChanges(list->items, is_planned);
  if (const auto* color = std::get_if<spec::HsvColor>(&value.form))
    return AnyChanges(color->items, is_planned);
  if (const auto* each = std::get_if<spec::Each>(&value.form))
    return Changes(*each->value, is_planned) || Changes(*each->count, is_planned);
  return std::holds_alternative<spec::Arrangement>(value.form) ||
         std::holds_alternative<spec::RandomRotation>(value.form) ||
         std::holds_alternative<spec::RotationAbout>(value.form) ||
         std::holds_alternative<spec::PointOnSphere>(value.form);
}

bool AnyChanges(std::span<const spec::Value> values, bool is_planned) {
  return std::ranges::any_of(values,
                             [&](const spec::Value& value) { return Changes(value, is_planned); });
}

}  // namespace

bool Evaluator::SampleShared(Overrides overrides) {
  return std::ranges::all_of(shared_, [&](Evaluator& shared) {
    failed_ |= !shared.Sample(overrides);
    return !failed_;
  });
}

// Returns true if the requirement is met. A requirement without a value, such as sqrt(-1) > 0, is
// not met, because another draw may give it a value. An infinite value or an index out of range is
// an error.
bool Evaluator::Holds(const spec::Requirement& requirement) {
  const expr::Expression& expression = requirement.expression;
  const double value = expression.Evaluate(variables_, lists_);
  if (std::isfinite(value)) return value != 0;
  const bool lacks_items = !expression.DescribeMissingItem(variables_, lists_).empty();
  if (lacks_items || std::isinf(value)) EvaluateExpression(expression, requirement.mark);
  return false;
}

std::optional<std::size_t> Evaluator::SampleParameters(Overrides overrides) {
  for (const int position : spec_.evaluation_order) {
    const spec::Parameter& parameter = spec_.parameters[static_cast<std::size_t>(position)];
    if (const ParameterValue* given = FindOverride(overrides, parameter)) {
      SetParameter(parameter, *given);
    } else {
      DrawParameter(parameter);
    }
  }
  if (failed_) return std::nullopt;
  std::size_t met = 0;
  while (met < spec_.requirements.size() && Holds(spec_.requirements[met])) ++met;
  if (failed_) return std::nullopt;
  return met;
}

bool Evaluator::Sample(Overrides overrides) {
  if (!SampleShared(overrides)) return false;
  const bool is_planned = sampler_ != nullptr && sampler_->batch() > 0;
  std::vector<std::uint64_t> rejections;  // number of draws that each requirement rejected
  for (std::uint64_t count = 0; count < kMaxAttempts; ++count, ++key_.attempt) {
    const std::optional<std::size_t> met = SampleParameters(overrides);
    if (!met) return false;
    if (*met == spec_.requirements.size()) return true;
    const auto changes = [&](const spec::Parameter& parameter) {
      return FindOverride(overrides, parameter) == nullptr && Changes(parameter.value, is_planned);
    };
    if (count == 0 && std::ranges::none_of(spec_.parameters, changes)) {
      ReportConstant(spec_.requirements[*met]);
      return false;
    }
    rejections.resize(spec_.requirements.size());
    ++rejections[*met];
  }
  ReportRejections(rejections);
  return false;
}

// Reports that `requirement` is not met, and that a redraw cannot help, because no parameter is
// drawn.
void Evaluator::ReportConstant(const spec::Requirement& requirement) {
  const std::string inputs = InputsText(requirement.expression);
  Fail(Code::kSampleRejected, requirement.mark,
       fmt::format("requirement '{}' does not hold{}{}", requirement.expression.text(),
                   inputs.empty() ? "" : ": ", inputs),
       "no parameter is drawn, so a redraw cannot help");
}

void Evaluator::ReportRejections(std::span<const std::uint64_t> rejections) {
  const auto worst = std::ranges::max_element(rejections) - rejections.begin();
  Fail(Code::kSampleRejected, spec_.requirements[static_cast<std::size_t>(worst)].mark,
       fmt::format("no draw in {} attempts met all requirements", kMaxAttempts),
       "loosen a requirement, or narrow the ranges it compares");
  std::vector<diag::Note>& notes = std::prev(findings_->end())->notes;
  for (std::size_t i = 0; i < rejections.size(); ++i) {
    const spec::Requirement& requirement = spec_.requirements[i];
    notes.push_back(
        {requirement.mark, fmt::format("'{}' rejected {}", requirement.expression.text(),
                                       diag::Counted(rejections[i], "time"))});
  }
}

std::optional<Evaluator> Sample(const spec::ObjectSpec& spec, DrawKey key, StreamId root,
                                Evaluator::Overrides overrides, diag::Findings& findings,
                                const Sampler* sampler) {
  std::optional<Evaluator> evaluator(std::in_place, spec, key, root, findings, sampler);
  if (!evaluator->Sample(overrides)) evaluator.reset();
  return evaluator;
}

}  // namespace mjforge::sample
