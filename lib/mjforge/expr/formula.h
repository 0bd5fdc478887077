#pragma once

// Private to the room: an expression translated for muParser.

#include <string>
#include <string_view>
#include <vector>

#include "mjforge/expr/expr.h"
#include "mjforge/expr/functions.h"

namespace mjforge::expr {

/// The only names in `text` are inputs (i0, i1, ...), constants (c0, ...) and functions (f0, ...),
/// so nothing in it depends on how muParser reads names and numbers, or on the locale. Its
/// operators are muParser's with the same precedence; `%` is Remainder().
struct Formula {
  std::string text;
  Type type = Type::kNumber;
  std::vector<Expression::Input> inputs;
  std::vector<double> constants;
  std::vector<const Callee*> callees;

  void Write(std::string_view words) { text += words; }
  void WriteConstant(double value);
  void WriteInput(std::string_view name, int slot, Type input_type);
  /// Up to and including the opening parenthesis.
  void WriteCall(const Callee& callee);

  /// True if it is just a constant or an input.
  bool IsLoneOperand() const { return text == "c0" || text == "i0"; }
};

}  // namespace mjforge::expr
