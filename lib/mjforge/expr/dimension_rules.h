// Dimensional analysis of expressions: checks the dimensions of arguments, and derives the
// dimensions of results. Private to lib/mjforge/expr.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "mjforge/expr/parser.h"

namespace mjforge::expr {

/// Returns the dimension of the result of `builtin`. If the arguments do not have the dimensions
/// that `builtin` requires, returns nullopt and sets `error`. `offset` is the position of the
/// error: a byte offset in the expression's text.
std::optional<Dimension> DeriveDimension(const Builtin& builtin,
                                         std::span<const Argument> arguments, std::size_t offset,
                                         Error& error);

/// Returns true if the argument is a plain number or its dimension is unknown. Otherwise returns
/// false and sets `error`. `what` describes the argument in the message ("an index"); `offset` is
/// the position of the error, a byte offset in the expression's text.
bool CheckCount(const Argument& argument, std::string_view what, std::size_t offset, Error& error);

/// Returns the dimension of a literal without a unit. Whole numbers up to 12, and 0.5, are counts,
/// because such numbers usually are factors (2 * length). The dimension of other numbers (9.81,
/// 700) is unknown.
Dimension DimensionOfLiteral(double number);

}  // namespace mjforge::expr
