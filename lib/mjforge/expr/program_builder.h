// Semantic actions of the parser: adds steps for names, literals and calls to a program. Private to
// lib/mjforge/expr.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mjforge/expr/parser.h"
#include "mjforge/expr/token_cursor.h"

namespace mjforge::expr {

class ProgramBuilder : protected TokenCursor {
 protected:
  using OptionalOperand = std::optional<TypedOperand>;  // nullopt after an error
  using Arguments = std::map<std::string_view, TypedOperand>;

  ProgramBuilder(std::string_view text, std::vector<Token> tokens, ParseState& state,
                 Arguments arguments);

  OptionalOperand Fail(Error error);
  OptionalOperand FailText(const TypedOperand& operand);

  /// Adds a number with its unit; `token` is the token before the current one.
  OptionalOperand Number(const Token& token);
  /// Returns a constant for the token before the current one.
  TypedOperand Literal(double value, Type type, Dimension dimension = {}) const;
  TypedOperand Quoted(const Token& token);
  /// Adds a call of a function or operator whose name or sign is at `offset`. Sets an error at
  /// `offset` if the dimensions of the arguments are wrong.
  OptionalOperand AddCall(const Builtin& builtin, Type type, std::span<const Argument> arguments,
                          std::size_t offset);
  /// Resolves the name before the current token. `beside_text`: the name is compared with a text.
  OptionalOperand ResolveName(const Token& token, bool beside_text);

  /// Returns true if the token with this index is the name of a list or a vector.
  bool IsListAt(std::size_t token) const;
  OptionalOperand AddElement(const Token& list, const Argument& argument);
  /// Adds a call of a list function for the list named by the token with this index. `count` limits
  /// the call to the first values; null means all.
  OptionalOperand AddListCall(const ListBuiltin& builtin, std::size_t token, const Argument* count);

  /// Adds the torque of the joint with this name.
  OptionalOperand AddTorque(const Token& joint);
  /// Adds the Euclidean distance of two sites or vectors of three components. The function's name
  /// is at `offset`.
  OptionalOperand AddDistance(const Token& a, const Token& b, std::size_t offset);

  const SymbolTable& names_;
  ParsedExpression& parsed_;
  Error& error_;

 private:
  OptionalOperand AddComponent(const Token& token, const SymbolTable::Variable& vector,
                               std::string_view component);
  TypedOperand AddInput(const Token& token, const SymbolTable::Variable& variable, int component);
  /// Returns the position of a site, or a vector of three components; null after an error.
  const SymbolTable::Variable* FindPoint(const Token& name);
  ListSource AddList(const SymbolTable::Variable& variable);
  void RecordItem(const SymbolTable::Variable& variable, int item);
  void RecordInput(std::string_view name, const SymbolTable::Variable& variable, int slot);

  Arguments arguments_;  // arguments of the function whose body is parsed
};

}  // namespace mjforge::expr
