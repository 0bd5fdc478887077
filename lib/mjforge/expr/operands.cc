#include "mjforge/expr/operands.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "mjforge/expr/complaints.h"
#include "mjforge/expr/measures.h"

namespace mjforge::expr {
namespace {

Measured MeasuredAs(const Typed& read, std::string_view source) {
  const bool is_constant = read.value.step < 0;
  return {.dimension = read.type == Type::kNumber ? read.dimension : Dimension::Count(),
          .source = source,
          .constant = is_constant ? std::optional(read.value.constant) : std::nullopt};
}

// What each value of a list or a vector measures; unknown if they differ.
Dimension OfAll(const Names::Variable& variable) {
  const bool is_one = variable.dimensions.size() == 1;
  return is_one ? variable.dimensions.front() : Dimension();
}

}  // namespace

Operands::Operands(std::string_view text, std::vector<Word> words, Parts& parts,
                   Arguments arguments)
    : Cursor(text, std::move(words)),
      names_(parts.names),
      parsed_(parts.parsed),
      error_(parts.error),
      arguments_(std::move(arguments)) {}

Operands::Result Operands::Fail(Error error) {
  error_ = std::move(error);
  return std::nullopt;
}

Operands::Result Operands::FailText(const Typed& operand) {
  return Fail(MisusedText(words_[operand.word]));
}

Typed Operands::Literal(double value, Type type, Dimension dimension) const {
  return {.value = {.constant = value}, .type = type, .word = at_ - 1, .dimension = dimension};
}

Typed Operands::Quoted(const Word& word) {
  parsed_.texts.emplace_back(word.text);
  return Literal(TextKey(word.text), Type::kText);
}

Operands::Result Operands::Applied(const Callee& callee, Type type,
                                   std::span<const Argument> arguments, std::size_t offset) {
  std::vector<Measured> measured;
  for (const auto& [read, source] : arguments) measured.push_back(MeasuredAs(read, source));
  const auto dimension = MeasureOf(callee, measured, offset, error_);
  if (!dimension) return std::nullopt;
  std::vector<Operand> operands;
  for (const auto& [read, source] : arguments) operands.push_back(read.value);
  // max(a, b, c) is max(max(a, b), c).
  Operand value = operands.front();
  if (callee.repeats) {
    for (const Operand& operand : std::span(operands).subspan(1))
      value = parsed_.program.Apply(callee, std::array{value, operand});
  } else {
    value = parsed_.program.Apply(callee, operands);
  }
  return Typed{.value = value, .type = type, .dimension = *dimension};
}

Operands::Result Operands::Named(const Word& word, bool beside_text) {
  if (const auto argument = arguments_.find(word.text); argument != arguments_.end())
    return Typed{argument->second.value, argument->second.type, at_ - 1,
                 argument->second.dimension};
  if (const Names::Variable* variable = names_.Find(word.text)) {
    if (variable->is_list()) return Fail(WholeList(word));
    if (variable->components > 1) return Fail(WrongComponent(word, *variable, {}));
    return Input(word, *variable, 0);
  }
  if (const Constant* constant = FindConstant(word.text)) {
    return Literal(constant->value, constant->is_boolean ? Type::kBoolean : Type::kNumber,
                   Dimension::Count());
  }
  const std::size_t dot = word.text.rfind('.');
  if (dot != std::string_view::npos) {
    if (const Names::Variable* vector = names_.Find(word.text.substr(0, dot))) {
      return Component(word, *vector, word.text.substr(dot + 1));
    }
  }
  return Fail(UnknownName(word, names_, beside_text));
}

Operands::Result Operands::Component(const Word& word, const Names::Variable& vector,
                                     std::string_view component) {
  const std::size_t index = std::string_view("xyzw").find(component);
  if (component.size() != 1 || index == std::string_view::npos || vector.components == 1 ||
      static_cast<int>(index) >= vector.components) {
    return Fail(WrongComponent(word, vector, component));
  }
  return Input(word, vector, static_cast<int>(index));
}

Typed Operands::Input(const Word& word, const Names::Variable& variable, int component) {
  const int slot = variable.slot + component;
  NoteInput(word.text, variable, slot);
  return {parsed_.program.Variable(slot), variable.type, at_ - 1,
          DimensionAt(variable.dimensions, static_cast<std::size_t>(component))};
}

void Operands::NoteInput(std::string_view name, const Names::Variable& variable, int slot) {
  if (std::ranges::find(parsed_.inputs, slot, &Expression::Input::slot) == parsed_.inputs.end())
    parsed_.inputs.push_back({std::string(name), slot, variable.type, variable.list});
}

void Operands::NoteItem(const Names::Variable& variable, int item) {
  std::string name = variable.name;
  if (!variable.is_list() && item < 4) name += {'.', "xyzw"[item]};
  NoteInput(name, variable, variable.slot + item);
}

bool Operands::IsListAt(std::size_t word) const {
  if (words_[word].kind != Word::Kind::kName) return false;
  const Names::Variable* variable = names_.Find(words_[word].text);
  return variable != nullptr && (variable->is_list() || variable->components > 1);
}

ListSource Operands::AsList(const Names::Variable& variable) {
  for (int i = 0; i < variable.components; ++i) NoteItem(variable, i);
  return {.slot = variable.slot,
          .list = variable.list,
          .components = variable.is_list() ? 0 : variable.components};
}

Operands::Result Operands::ElementOf(const Word& list, const Argument& argument) {
  const Names::Variable& variable = *names_.Find(list.text);
  const std::size_t word = static_cast<std::size_t>(&list - words_.data());
  const Typed& index = argument.read;
  if (!IsCount(MeasuredAs(index, argument.source), "the number of a value in a list", list.offset,
               error_))
    return std::nullopt;
  // A vector's length is known.
  if (const bool is_known = !variable.is_list() && index.value.step < 0; is_known) {
    const double number = index.value.constant;
    for (int i = 0; i < variable.components; ++i) {
      if (i != number) continue;
      NoteItem(variable, i);
      return Typed{parsed_.program.Variable(variable.slot + i), variable.type, word,
                   DimensionAt(variable.dimensions, static_cast<std::size_t>(i))};
    }
    return Fail(NoSuchElement(list, number, variable.components));
  }
  return Typed{parsed_.program.Apply(*FindListCallee("[]"), AsList(variable), index.value),
               variable.type, word, OfAll(variable)};
}

Operands::Result Operands::OfList(const ListCallee& callee, std::size_t word,
                                  const Argument* count) {
  const Names::Variable& variable = *names_.Find(words_[word].text);
  const ListCallee& length = *FindListCallee("len");
  const ListSource source = AsList(variable);
  const Operand all = variable.is_list() ? parsed_.program.Apply(length, source, {})
                                         : Operand{.constant = 1.0 * variable.components};
  if (&callee == &length) return Typed{.value = all, .dimension = Dimension::Count()};
  if (variable.type == Type::kText) return Fail(MisusedText(words_[word]));
  if (count != nullptr && !IsCount(MeasuredAs(count->read, count->source), "how many to add",
                                   words_[word].offset, error_))
    return std::nullopt;
  const Operand& argument = count != nullptr ? count->read.value : all;
  return Typed{.value = parsed_.program.Apply(callee, source, argument),
               .dimension = OfAll(variable)};
}

}  // namespace mjforge::expr
