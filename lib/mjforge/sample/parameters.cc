// The part of Evaluator that gives the parameters their values.

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "mjforge/sample/dimensions.h"
#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

using diag::Code;
using expr::Type;

bool IsVector(const spec::Value& value) {
  return !value.is_list && (value.components > 1 || std::holds_alternative<spec::List>(value.form));
}

std::size_t Slot(const spec::Parameter& parameter) {
  return static_cast<std::size_t>(parameter.slot);
}

std::string KindText(const ParameterValue& value) {
  if (std::holds_alternative<std::string>(value)) return spec::KindText(Type::kText, 1);
  if (std::holds_alternative<bool>(value)) return spec::KindText(Type::kBoolean, 1);
  if (const auto* texts = std::get_if<std::vector<std::string>>(&value))
    return fmt::format("{} texts", texts->size());
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  return spec::KindText(Type::kNumber, numbers ? numbers->size() : 1);
}

std::vector<double> KeysOf(const std::vector<std::string>& texts) {
  std::vector<double> keys(texts.size());
  std::ranges::transform(texts, keys.begin(), expr::TextKey);
  return keys;
}

}  // namespace

Evaluator::Evaluator(const spec::ObjectSpec& spec, DrawKey key, StreamId root,
                     diag::Findings& findings, const Sampler* sampler)
    : spec_(spec),
      key_(key),
      root_(root == kRootStream ? RootStream(spec) : root),
      findings_(&findings),
      sampler_(sampler),
      variables_(static_cast<std::size_t>(spec.names.slot_count())),
      texts_(variables_.size()),
      lists_(static_cast<std::size_t>(spec.names.list_count())),
      list_texts_(lists_.size()) {
  if (!variables_.empty()) variables_[0] = static_cast<double>(key.index);
  const StreamId parameters = Child(root_, "params");
  streams_.reserve(spec.parameters.size());
  for (const spec::Parameter& parameter : spec.parameters) {
    streams_.push_back(Child(parameters, parameter.name));
  }
  // Imported parameters always begin with attempt 0, so that a retry in one spec does not change
  // what another one sees.
  const DrawKey shared_key = {key.seed, key.index, 0};
  for (const auto& shared : spec.shared)
    shared_.emplace_back(*shared, shared_key, SharedStream(*shared), findings, sampler);
}

void Evaluator::SetComponents(const spec::Parameter& parameter,
                              std::span<const double> components) {
  const auto wanted = static_cast<std::size_t>(parameter.value.components);
  if (components.size() == wanted) {
    std::ranges::copy(components, variables_.begin() + parameter.slot);
    return;
  }
  const double none = Fail(Code::kSampleBadArgument, parameter.mark,
                           fmt::format("parameter '{}' is {}, but its value is {}", parameter.name,
                                       spec::KindText(parameter.value),
                                       spec::KindText(Type::kNumber, components.size())));
  std::fill_n(variables_.begin() + parameter.slot, wanted, none);
}

void Evaluator::SetList(const spec::Parameter& parameter, std::vector<double> numbers,
                        std::vector<std::string> texts) {
  const auto list = static_cast<std::size_t>(parameter.list);
  variables_[Slot(parameter)] = static_cast<double>(numbers.size());
  lists_[list] = expr::Sequence(std::move(numbers));
  list_texts_[list] = std::move(texts);
}

void Evaluator::DrawParameter(std::size_t i) {
  const spec::Parameter& parameter = spec_.parameters[i];
  const spec::Value& value = parameter.value;
  if (const auto* shared = std::get_if<spec::SharedParameter>(&value.form)) {
    SetParameter(parameter, shared_[shared->file].Parameter(shared->position));
  } else if (value.is_list) {
    Items items = List(value, streams_[i]);
    SetList(parameter, {items.numbers.begin(), items.numbers.end()}, std::move(items.texts));
  } else if (value.type == Type::kText) {
    texts_[Slot(parameter)] = Text(value, streams_[i]);
    variables_[Slot(parameter)] = expr::TextKey(texts_[Slot(parameter)]);
  } else if (IsVector(value)) {
    Numbers components;
    AppendVector(value, streams_[i], components);
    SetComponents(parameter, {components.data(), components.size()});
  } else {
    variables_[Slot(parameter)] = Number(value, streams_[i]);
  }
}

void Evaluator::SetParameter(const spec::Parameter& parameter, const ParameterValue& value) {
  const Type type = parameter.value.type;
  const bool is_list = parameter.value.is_list;
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  if (const auto* text = std::get_if<std::string>(&value);
      text && type == Type::kText && !is_list) {
    texts_[Slot(parameter)] = *text;
    variables_[Slot(parameter)] = expr::TextKey(*text);
  } else if (const auto* boolean = std::get_if<bool>(&value); boolean && type == Type::kBoolean) {
    variables_[Slot(parameter)] = *boolean ? 1 : 0;
  } else if (const auto* number = std::get_if<double>(&value);
             number && type == Type::kNumber && !is_list) {
    SetComponents(parameter, {number, 1});
  } else if (numbers != nullptr && type == Type::kNumber && !is_list) {
    SetComponents(parameter, *numbers);
  } else if (const auto* texts = std::get_if<std::vector<std::string>>(&value);
             texts && type == Type::kText && is_list) {
    SetList(parameter, KeysOf(*texts), *texts);
  } else if (numbers != nullptr && is_list && (type == Type::kNumber || numbers->empty())) {
    SetList(parameter, *numbers, {});
  } else {
    const auto count = static_cast<std::size_t>(parameter.value.components);
    const double none =
        Fail(Code::kSampleBadArgument, parameter.mark,
             fmt::format("parameter '{}' is {}, but its value is {}", parameter.name,
                         spec::KindText(parameter.value), KindText(value)));
    std::fill_n(variables_.begin() + parameter.slot, count, none);
  }
}

bool Evaluator::SampleShared(Overrides overrides) {
  return std::ranges::all_of(shared_, [&](Evaluator& shared) {
    failed_ |= !shared.Sample(overrides);
    return !failed_;
  });
}

// One without a value, such as sqrt(-1) > 0, does not: another draw may have one.
bool Evaluator::Holds(const spec::Requirement& requirement) {
  const expr::Expression& expression = requirement.expression;
  const double value = expression.Evaluate(variables_, lists_);
  if (std::isfinite(value)) return value != 0;
  const bool lacks_items = !expression.DescribeMissingItem(variables_, lists_).empty();
  return (lacks_items || std::isinf(value)) && Condition(expression, requirement.mark);
}

bool Evaluator::SampleParameters(Overrides overrides) {
  rejected_by_ = -1;
  for (const int position : spec_.evaluation_order) {
    const auto i = static_cast<std::size_t>(position);
    const spec::Parameter& parameter = spec_.parameters[i];
    const auto given = std::ranges::find(overrides, parameter.name,
                                         &std::pair<std::string, ParameterValue>::first);
    if (given != overrides.end()) {
      SetParameter(parameter, given->second);
    } else {
      DrawParameter(i);
    }
  }
  if (failed_) return false;
  for (std::size_t i = 0; i < spec_.requirements.size(); ++i) {
    const spec::Requirement& requirement = spec_.requirements[i];
    if (Holds(requirement)) continue;
    if (!failed_) rejected_by_ = static_cast<int>(i);
    return false;
  }
  return true;
}

void Evaluator::SetLocal(const spec::Local& local, StreamId path) {
  const spec::Value& value = local.value;
  if (value.type == Type::kText) {
    SetVariable(local.slot, Text(value, path));
  } else if (!IsVector(value)) {
    SetVariable(local.slot, Number(value, path));
  } else {
    Numbers components;
    AppendVector(value, path, components);
    components.resize(static_cast<std::size_t>(value.components));  // as the spec was checked
    for (int k = 0; k < value.components; ++k)
      SetVariable(local.slot + k, components[static_cast<std::size_t>(k)]);
  }
}

ParameterValue Evaluator::Any(const spec::Value& value, StreamId path) {
  if (value.is_list) {
    Items items = List(value, path);
    if (value.type == Type::kText) return std::move(items.texts);
    return std::vector<double>(items.numbers.begin(), items.numbers.end());
  }
  if (value.type == Type::kText) return Text(value, path);
  if (value.type == Type::kBoolean) return Boolean(value, path);
  if (!IsVector(value)) return Number(value, path);
  Numbers numbers;
  AppendVector(value, path, numbers);
  return std::vector<double>(numbers.begin(), numbers.end());
}

ParameterValue Evaluator::Parameter(std::size_t i) const {
  const spec::Parameter& parameter = spec_.parameters[i];
  const std::size_t slot = Slot(parameter);
  const bool is_text = parameter.value.type == Type::kText;
  if (parameter.value.is_list) {
    const auto list = static_cast<std::size_t>(parameter.list);
    if (is_text) return list_texts_[list];
    return lists_[list].numbers();
  }
  if (is_text) return texts_[slot];
  if (parameter.value.type == Type::kBoolean) return variables_[slot] != 0;
  if (!IsVector(parameter.value)) return variables_[slot];
  const auto first = variables_.begin() + parameter.slot;
  return std::vector<double>(first, first + parameter.value.components);
}

}  // namespace mjforge::sample
