#pragma once

// Private to the room.

#include <string_view>

#include "mjforge/expr/expr.h"
#include "mjforge/expr/formula.h"

namespace mjforge::expr {

/// Checks `text` and fills `formula`. On failure returns false and fills `error`.
bool ParseFormula(std::string_view text, const Names& names, Formula& formula, Error& error);

}  // namespace mjforge::expr
