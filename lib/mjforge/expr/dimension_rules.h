// Dimensional analysis: checks of the dimensions of arguments, and dimensions of results. Private
// to lib/mjforge/expr.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "mjforge/expr/parser.h"

namespace mjforge::expr {

/// Returns the dimension of the result of `builtin`. If the arguments do not have the dimensions
/// that `builtin` requires, returns nullopt and sets `error` at `offset`, in bytes.
std::optional<Dimension> DeriveDimension(const Builtin& builtin,
                                         std::span<const Argument> arguments, std::size_t offset,
                                         Error& error);

/// Returns true if the argument is a plain number or its dimension is unknown. Otherwise returns
/// false and sets `error` at `offset`, in bytes; `what` describes the argument in the message ("an
/// index").
bool CheckCount(const Argument& argument, std::string_view what, std::size_t offset, Error& error);

/// Returns the dimension of a literal without a unit. Small whole numbers and 0.5 are counts,
/// because twice a length is a length. The dimension of other numbers (9.81, 700) is unknown.
Dimension DimensionOfLiteral(double number);

}  // namespace mjforge::expr
