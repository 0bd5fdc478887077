// Functions of Evaluator that set and return the values of parameters and local values.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mjforge/sample/dimensions.h"
#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

using expr::Type;

bool IsVector(const spec::Value& value) {
  return !value.is_list && (value.components > 1 || std::holds_alternative<spec::List>(value.form));
}

std::string KindText(const ParameterValue& value) {
  if (std::holds_alternative<std::string>(value)) return spec::KindText(Type::kText, 1);
  if (std::holds_alternative<bool>(value)) return spec::KindText(Type::kBoolean, 1);
  if (const auto* texts = std::get_if<std::vector<std::string>>(&value))
    return fmt::format("{} texts", texts->size());
  if (const auto* booleans = std::get_if<std::vector<bool>>(&value))
    return fmt::format("{} booleans", booleans->size());
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  return spec::KindText(Type::kNumber, numbers ? numbers->size() : 1);
}

// Returns the numbers that represent the items of a list in expressions.
std::vector<double> NumbersOf(const ParameterValue& list) {
  if (const auto* texts = std::get_if<std::vector<std::string>>(&list)) {
    std::vector<double> keys(texts->size());
    std::ranges::transform(*texts, keys.begin(), expr::TextKey);
    return keys;
  }
  if (const auto* booleans = std::get_if<std::vector<bool>>(&list))
    return std::vector<double>(booleans->begin(), booleans->end());
  return std::get<std::vector<double>>(list);
}

// Returns a list of items of this type as the value of a parameter.
ParameterValue ValueOf(Type type, Items items) {
  if (type == Type::kText) return std::move(items.texts);
  if (type == Type::kNumber) return std::move(items.numbers);
  std::vector<bool> booleans(items.numbers.size());
  std::transform(items.numbers.begin(), items.numbers.end(), booleans.begin(),
                 [](double number) { return number != 0; });
  return booleans;
}

// Returns true if the value can be assigned to the parameter: the types and, for a vector, the
// numbers of components must be equal. An empty list of numbers can be assigned to every list.
bool Accepts(const spec::Value& parameter, const ParameterValue& value) {
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  if (std::holds_alternative<std::vector<std::string>>(value))
    return parameter.is_list && parameter.type == Type::kText;
  if (std::holds_alternative<std::vector<bool>>(value))
    return parameter.is_list && parameter.type == Type::kBoolean;
  if (numbers != nullptr && parameter.is_list)
    return parameter.type == Type::kNumber || numbers->empty();
  if (std::holds_alternative<bool>(value))
    return parameter.type == Type::kBoolean && !parameter.is_list;
  if (std::holds_alternative<std::string>(value))
    return parameter.type == Type::kText && !parameter.is_list;
  const std::size_t count = numbers != nullptr ? numbers->size() : 1;
  return parameter.type == Type::kNumber && !parameter.is_list &&
         count == static_cast<std::size_t>(parameter.components);
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
  // Imported parameters always start with attempt 0, so that a redraw in one spec does not change
  // the values that another spec imports.
  const DrawKey shared_key = {key.seed, key.index, 0};
  for (const auto& shared : spec.shared)
    shared_.emplace_back(*shared, shared_key, SharedStream(*shared), findings, sampler);
}

void Evaluator::SetVariable(int slot, double value) {
  variables_[static_cast<std::size_t>(slot)] = value;
}

void Evaluator::SetVariable(int slot, std::string_view text) {
  texts_[static_cast<std::size_t>(slot)] = text;
  SetVariable(slot, expr::TextKey(text));
}

void Evaluator::Assign(int slot, const ParameterValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    SetVariable(slot, *text);
  } else if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    std::ranges::copy(*numbers, variables_.begin() + slot);
  } else if (const auto* boolean = std::get_if<bool>(&value)) {
    SetVariable(slot, *boolean ? 1.0 : 0.0);
  } else {
    SetVariable(slot, std::get<double>(value));
  }
}

void Evaluator::SetVariable(const spec::Loop& loop, const LoopRange& range, std::size_t i) {
  if (!range.items) {
    SetVariable(loop.slot, static_cast<double>(i));
  } else if (loop.range.type == Type::kText) {
    SetVariable(loop.slot, range.items->texts[i]);
  } else {
    SetVariable(loop.slot, range.items->numbers[i]);
  }
}

SavedVariables Evaluator::Save(const spec::Entry& entry) const {
  SavedVariables saved;
  const auto add = [&](int first, int count) {
    for (int slot = first; slot < first + count; ++slot)
      saved.push_back({slot, Variable(slot), texts_[static_cast<std::size_t>(slot)]});
  };
  for (const spec::Loop& loop : entry.loops) add(loop.slot, 1);
  for (const spec::Local& local : entry.locals)
    add(local.slot, std::max(local.value.components, 1));
  return saved;
}

void Evaluator::Restore(const SavedVariables& saved) {
  for (const SavedVariable& variable : saved) {
    SetVariable(variable.slot, variable.number);
    texts_[static_cast<std::size_t>(variable.slot)] = variable.text;
  }
}

void Evaluator::ClearVariables(int slot, int list, const spec::Value& value) {
  const int count = value.is_list ? 1 : std::max(value.components, 1);
  for (int k = 0; k < count; ++k) SetVariable(slot + k, kFailedNumber);
  if (list >= 0) lists_[static_cast<std::size_t>(list)] = expr::Sequence({kFailedNumber});
}

bool Evaluator::SetLocal(const spec::Local& local, StreamId path) {
  const std::optional<ParameterValue> value = Any(local.value, path);
  if (value) {
    Assign(local.slot, *value);
  } else {
    ClearVariables(local.slot, -1, local.value);
  }
  return value.has_value();
}

void Evaluator::SetParameter(const spec::Parameter& parameter, const ParameterValue& value) {
  if (!Accepts(parameter.value, value)) {
    ClearVariables(parameter.slot, parameter.list, parameter.value);
    Fail(diag::Code::kSampleBadArgument, parameter.mark,
         fmt::format("parameter '{}' is {}, but its value is {}", parameter.name,
                     spec::KindText(parameter.value), KindText(value)));
    return;
  }
  if (!parameter.value.is_list) return Assign(parameter.slot, value);
  const auto list = static_cast<std::size_t>(parameter.list);
  const auto* texts = std::get_if<std::vector<std::string>>(&value);
  list_texts_[list] = texts != nullptr ? *texts : std::vector<std::string>();
  lists_[list] = expr::Sequence(NumbersOf(value));
  SetVariable(parameter.slot, static_cast<double>(lists_[list].numbers().size()));
}

void Evaluator::DrawParameter(const spec::Parameter& parameter) {
  std::optional<ParameterValue> value;
  if (const auto* shared = std::get_if<spec::SharedParameter>(&parameter.value.form)) {
    value = shared_[shared->file].Parameter(shared->position);
  } else {
    value = Any(parameter.value, Child(Child(root_, "params"), parameter.name));
  }
  if (value) {
    SetParameter(parameter, *value);
  } else {
    ClearVariables(parameter.slot, parameter.list, parameter.value);
  }
}

std::optional<ParameterValue> Evaluator::Any(const spec::Value& value, StreamId path) {
  if (value.is_list) {
    std::optional<Items> items = List(value, path);
    if (!items) return std::nullopt;
    return ValueOf(value.type, *std::move(items));
  }
  if (value.type == Type::kText) return Text(value, path);
  if (value.type == Type::kBoolean) return Boolean(value, path);
  Numbers numbers;
  AppendVector(value, path, numbers);
  if (HasFailedNumber(numbers)) return std::nullopt;
  if (!IsVector(value)) return numbers.front();
  return std::vector<double>(numbers.begin(), numbers.end());
}

ParameterValue Evaluator::Parameter(std::size_t i) const {
  const spec::Parameter& parameter = spec_.parameters[i];
  const auto slot = static_cast<std::size_t>(parameter.slot);
  const Type type = parameter.value.type;
  if (parameter.value.is_list) {
    const auto list = static_cast<std::size_t>(parameter.list);
    return ValueOf(type, {lists_[list].numbers(), list_texts_[list]});
  }
  if (type == Type::kText) return texts_[slot];
  if (type == Type::kBoolean) return variables_[slot] != 0;
  if (!IsVector(parameter.value)) return variables_[slot];
  const auto first = variables_.begin() + parameter.slot;
  return std::vector<double>(first, first + parameter.value.components);
}

}  // namespace mjforge::sample
