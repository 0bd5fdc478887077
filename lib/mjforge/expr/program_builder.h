// Cursor through the tokens of an expression, and semantic actions of the parser, which add steps
// for names, literals and calls to a program. Private to lib/mjforge/expr.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mjforge/expr/parser.h"
#include "mjforge/expr/tokens.h"

namespace mjforge::expr {

class ProgramBuilder {
 protected:
  using OptionalOperand = std::optional<TypedOperand>;  // nullopt after an error
  using Arguments = std::map<std::string_view, TypedOperand>;

  ProgramBuilder(std::string_view text, std::vector<Token> tokens, ParseState& state,
                 Arguments arguments);

  /// Returns the token that is read next.
  const Token& Now() const { return tokens_[at_]; }
  /// Reads the next token if it is this sign; otherwise returns false.
  bool Take(std::string_view sign) {
    if (!Now().IsSign(sign)) return false;
    ++at_;
    return true;
  }
  /// Returns true if the next token is the sign of a comparison.
  bool AtComparison() const;
  /// Returns the source text from the start of token `begin` to the start of token `end`, without
  /// blanks at its end.
  std::string_view Source(std::size_t begin, std::size_t end) const;

  OptionalOperand Fail(Error error);
  OptionalOperand FailText(const TypedOperand& operand);

  /// Returns the operand for a number with its unit, in SI units. Sets an error if the unit is
  /// unknown. `token` is the token of the number, which was already read.
  OptionalOperand Number(const Token& token);
  /// Returns the operand for a constant, whose token must be the last one that was read.
  TypedOperand Literal(double value, Type type, Dimension dimension = {}) const;
  TypedOperand Quoted(const Token& token);
  /// Adds a call of a function or operator. If the dimensions of the arguments are wrong, sets an
  /// error at `offset`, the offset of the function's name or of the operator's sign.
  OptionalOperand AddCall(const Builtin& builtin, Type type, std::span<const Argument> arguments,
                          std::size_t offset);
  /// Returns the operand for a name, whose token was already read. `beside_text` is true if the
  /// name is compared with a text.
  OptionalOperand ResolveName(const Token& token, bool beside_text);

  /// Returns true if the token with this index is the name of a list or a vector.
  bool IsListAt(std::size_t token) const;
  OptionalOperand AddElement(const Token& list, const Argument& argument);
  /// Adds a call of a list function. `token` is the index of the token with the list's name. If
  /// `count` is not null, the function applies only to the first `count` values.
  OptionalOperand AddListCall(const ListBuiltin& builtin, std::size_t token, const Argument* count);

  /// Returns the operand for torque(`joint`). Sets an error if the expression cannot use the torque
  /// of this joint.
  OptionalOperand AddTorque(const Token& joint);
  /// Adds steps that compute the Euclidean distance of two points, which are sites or vectors of
  /// three components. `offset` is the offset of the function's name.
  OptionalOperand AddDistance(const Token& a, const Token& b, std::size_t offset);

  std::vector<Token> tokens_;
  std::size_t at_ = 0;  // index of the token that is read next
  const SymbolTable& names_;
  ParsedExpression& parsed_;
  Error& error_;

 private:
  OptionalOperand AddComponent(const Token& token, const SymbolTable::Variable& vector,
                               std::string_view component);
  /// Adds the step that reads a component of a variable; component 0 of a variable with only one is
  /// its value. `token` is the index of the token that names the variable.
  TypedOperand AddVariable(const SymbolTable::Variable& variable, int component, std::size_t token);
  /// Returns the variable of a site's position, or of a vector of three components. Returns null,
  /// and sets an error, for other names.
  const SymbolTable::Variable* FindPoint(const Token& name);
  ListSource AddList(const SymbolTable::Variable& variable);
  void RecordInput(const SymbolTable::Variable& variable, int component);

  std::string_view text_;
  Arguments arguments_;  // operands for the arguments of the function whose body is parsed
};

}  // namespace mjforge::expr
