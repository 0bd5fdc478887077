// Semantic actions of the parser: resolution of names, checks of types, and steps of the program.
#include "mjforge/expr/program_builder.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "mjforge/expr/dimension_rules.h"
#include "mjforge/expr/error_messages.h"

namespace mjforge::expr {
namespace {

// Returns the dimension that was declared for all values of a list or vector; an unknown dimension
// if each component has its own. Booleans are counts.
Dimension DimensionOfItems(const SymbolTable::Variable& variable) {
  if (variable.type == Type::kBoolean) return Dimension::Count();
  const bool is_one = variable.dimensions.size() == 1;
  return is_one ? variable.dimensions.front() : Dimension();
}

}  // namespace

ProgramBuilder::ProgramBuilder(std::string_view text, std::vector<Token> tokens, ParseState& state,
                               Arguments arguments)
    : tokens_(std::move(tokens)),
      names_(state.names),
      parsed_(state.parsed),
      error_(state.error),
      text_(text),
      arguments_(std::move(arguments)) {}

bool ProgramBuilder::AtComparison() const {
  static constexpr std::array<std::string_view, 6> kSigns = {"<", "<=", ">", ">=", "==", "!="};
  return Now().kind == Token::Kind::kSign && std::ranges::find(kSigns, Now().text) != kSigns.end();
}

std::string_view ProgramBuilder::Source(std::size_t begin, std::size_t end) const {
  const std::size_t from = tokens_[begin].offset;
  std::string_view source = text_.substr(from, tokens_[end].offset - from);
  while (source.ends_with(' ') || source.ends_with('\n')) source.remove_suffix(1);
  return source;
}

ProgramBuilder::OptionalOperand ProgramBuilder::Fail(Error error) {
  error_ = std::move(error);
  return std::nullopt;
}

ProgramBuilder::OptionalOperand ProgramBuilder::FailText(const TypedOperand& operand) {
  return Fail(MisusedText(tokens_[operand.token]));
}

ProgramBuilder::OptionalOperand ProgramBuilder::Number(const Token& token) {
  if (token.unit.empty())
    return Literal(token.number, Type::kNumber, DimensionOfLiteral(token.number));
  const Unit* unit = FindUnitSuffix(token.unit);
  if (unit == nullptr) return Fail(UnknownUnit(token, names_));
  return Literal(token.number * unit->numerator / unit->denominator, Type::kNumber,
                 unit->dimension);
}

TypedOperand ProgramBuilder::Literal(double value, Type type, Dimension dimension) const {
  return {.value = {.constant = value}, .type = type, .token = at_ - 1, .dimension = dimension};
}

TypedOperand ProgramBuilder::Quoted(const Token& token) {
  parsed_.texts.emplace_back(token.text);
  return Literal(TextKey(token.text), Type::kText);
}

ProgramBuilder::OptionalOperand ProgramBuilder::AddCall(const Builtin& builtin, Type type,
                                                        std::span<const Argument> arguments,
                                                        std::size_t offset) {
  const auto dimension = DeriveDimension(builtin, arguments, offset, error_);
  if (!dimension) return std::nullopt;
  std::vector<Operand> operands;
  for (const Argument& argument : arguments) operands.push_back(argument.operand.value);
  // max(a, b, c) is max(max(a, b), c).
  Operand value = operands.front();
  if (builtin.is_variadic) {
    for (const Operand& operand : std::span(operands).subspan(1))
      value = parsed_.program.Apply(builtin, std::array{value, operand});
  } else {
    value = parsed_.program.Apply(builtin, operands);
  }
  return TypedOperand{.value = value, .type = type, .dimension = *dimension};
}

ProgramBuilder::OptionalOperand ProgramBuilder::ResolveName(const Token& token, bool beside_text) {
  if (const auto argument = arguments_.find(token.text); argument != arguments_.end())
    return TypedOperand{argument->second.value, argument->second.type, at_ - 1,
                        argument->second.dimension};
  if (const SymbolTable::Variable* variable = names_.Find(token.text)) {
    if (variable->is_list()) return Fail(WholeList(token));
    if (variable->components > 1) return Fail(WrongComponent(token, *variable, {}));
    return AddVariable(*variable, 0, at_ - 1);
  }
  if (const Constant* constant = FindConstant(token.text)) {
    return Literal(constant->value, constant->is_boolean ? Type::kBoolean : Type::kNumber,
                   Dimension::Count());
  }
  const std::size_t dot = token.text.rfind('.');
  if (dot != std::string_view::npos) {
    if (const SymbolTable::Variable* vector = names_.Find(token.text.substr(0, dot))) {
      return AddComponent(token, *vector, token.text.substr(dot + 1));
    }
  }
  return Fail(UnknownName(token, names_, beside_text));
}

ProgramBuilder::OptionalOperand ProgramBuilder::AddComponent(const Token& token,
                                                             const SymbolTable::Variable& vector,
                                                             std::string_view component) {
  const std::size_t index = kComponents.find(component);
  if (component.size() != 1 || index == std::string_view::npos || vector.components == 1 ||
      static_cast<int>(index) >= vector.components) {
    return Fail(WrongComponent(token, vector, component));
  }
  return AddVariable(vector, static_cast<int>(index), at_ - 1);
}

TypedOperand ProgramBuilder::AddVariable(const SymbolTable::Variable& variable, int component,
                                         std::size_t token) {
  RecordInput(variable, component);
  return {parsed_.program.Variable(variable.slot + component), variable.type, token,
          DimensionAt(variable.dimensions, static_cast<std::size_t>(component))};
}

void ProgramBuilder::RecordInput(const SymbolTable::Variable& variable, int component) {
  const int slot = variable.slot + component;
  if (std::ranges::find(parsed_.inputs, slot, &Expression::Input::slot) != parsed_.inputs.end())
    return;
  std::string name = variable.name;
  if (variable.components > 1 && component < 4)
    name += {'.', kComponents[static_cast<std::size_t>(component)]};
  parsed_.inputs.push_back({name, slot, variable.type, variable.list});
}

bool ProgramBuilder::IsListAt(std::size_t token) const {
  if (tokens_[token].kind != Token::Kind::kName) return false;
  const SymbolTable::Variable* variable = names_.Find(tokens_[token].text);
  return variable != nullptr && (variable->is_list() || variable->components > 1);
}

ListSource ProgramBuilder::AddList(const SymbolTable::Variable& variable) {
  for (int i = 0; i < variable.components; ++i) RecordInput(variable, i);
  return {.slot = variable.slot,
          .list = variable.list,
          .components = variable.is_list() ? 0 : variable.components};
}

ProgramBuilder::OptionalOperand ProgramBuilder::AddElement(const Token& list,
                                                           const Argument& argument) {
  const SymbolTable::Variable& variable = *names_.Find(list.text);
  const std::size_t token = static_cast<std::size_t>(&list - tokens_.data());
  const TypedOperand& index = argument.operand;
  if (!CheckCount(argument, "the number of a value in a list", list.offset, error_))
    return std::nullopt;
  // A constant index of a vector is checked during compilation, because the number of components is
  // known.
  if (const bool is_known = !variable.is_list() && index.value.step < 0; is_known) {
    const double number = index.value.constant;
    for (int i = 0; i < variable.components; ++i) {
      if (i == number) return AddVariable(variable, i, token);
    }
    return Fail(NoSuchElement(list, number, variable.components));
  }
  return TypedOperand{parsed_.program.Apply(*FindListBuiltin("[]"), AddList(variable), index.value),
                      variable.type, token, DimensionOfItems(variable)};
}

ProgramBuilder::OptionalOperand ProgramBuilder::AddTorque(const Token& joint) {
  const SymbolTable::Variable* torque = names_.Find(TorqueVariable(joint.text));
  if (torque == nullptr) return Fail(UnknownJoint(joint, names_));
  return AddVariable(*torque, 0, at_ - 1);
}

const SymbolTable::Variable* ProgramBuilder::FindPoint(const Token& name) {
  const SymbolTable::Variable* position = names_.Find(PositionVariable(name.text));
  if (position == nullptr) position = names_.Find(name.text);
  if (position != nullptr && position->components == 3) return position;
  Fail(UnknownPoint(name, names_));
  return nullptr;
}

ProgramBuilder::OptionalOperand ProgramBuilder::AddDistance(const Token& a, const Token& b,
                                                            std::size_t offset) {
  const SymbolTable::Variable* from = FindPoint(a);
  const SymbolTable::Variable* to = from == nullptr ? nullptr : FindPoint(b);
  if (to == nullptr) return std::nullopt;
  const auto call = [&](const Builtin& builtin, auto... operands) {
    return AddCall(builtin, Type::kNumber, std::array{Argument{operands, {}}...}, offset);
  };
  OptionalOperand sum;
  for (int i = 0; i < 3; ++i) {
    const TypedOperand start = AddVariable(*from, i, at_ - 1);
    const OptionalOperand side = call(Operator("-"), start, AddVariable(*to, i, at_ - 1));
    if (!side) return side;
    const OptionalOperand square = call(Operator("*"), *side, *side);
    sum = sum ? call(Operator("+"), *sum, *square) : square;
  }
  return call(*FindBuiltin("sqrt"), *sum);
}

ProgramBuilder::OptionalOperand ProgramBuilder::AddListCall(const ListBuiltin& builtin,
                                                            std::size_t token,
                                                            const Argument* count) {
  const SymbolTable::Variable& variable = *names_.Find(tokens_[token].text);
  const ListBuiltin& length = *FindListBuiltin("len");
  const ListSource source = AddList(variable);
  const Operand all = variable.is_list() ? parsed_.program.Apply(length, source, {})
                                         : Operand{.constant = 1.0 * variable.components};
  if (&builtin == &length) return TypedOperand{.value = all, .dimension = Dimension::Count()};
  if (variable.type == Type::kText) return Fail(MisusedText(tokens_[token]));
  if (count != nullptr && !CheckCount(*count, "how many to add", tokens_[token].offset, error_))
    return std::nullopt;
  const Operand& argument = count != nullptr ? count->operand.value : all;
  return TypedOperand{.value = parsed_.program.Apply(builtin, source, argument),
                      .dimension = DimensionOfItems(variable)};
}

}  // namespace mjforge::expr
