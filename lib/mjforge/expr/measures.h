#pragma once

// Private to the room: whether the units of a function's arguments fit, and what comes out.

#include <optional>
#include <span>
#include <string_view>

#include "mjforge/expr/dimension.h"
#include "mjforge/expr/expr.h"
#include "mjforge/expr/functions.h"

namespace mjforge::expr {

/// An argument, or an operand.
struct Measured {
  Dimension dimension;
  std::string_view source;         // as written
  std::optional<double> constant;  // its value, if it is known
};

/// What the result measures. If the arguments do not fit, nothing, and `error` at `offset`.
std::optional<Dimension> MeasureOf(const Callee& callee, std::span<const Measured> arguments,
                                   std::size_t offset, Error& error);

/// Whether it is a plain number, as `what` ("an index") is; else `error` at `offset`.
bool IsCount(const Measured& argument, std::string_view what, std::size_t offset, Error& error);

/// What a number without a unit measures. A small whole number and a half are counts: twice a
/// length is a length. Any other may measure something: 9.81, 700.
Dimension OfPlainNumber(double number);

}  // namespace mjforge::expr
