#pragma once

// Private to the room.

#include <string_view>
#include <vector>

#include "mjforge/expr/expr.h"
#include "mjforge/expr/program.h"

namespace mjforge::expr {

/// An expression that has been read.
struct Parsed {
  Program program;
  Type type = Type::kNumber;
  std::vector<Expression::Input> inputs;  // in order of first use
};

/// Reads and checks `text`. On failure returns false and fills `error`.
bool Parse(std::string_view text, const Names& names, Parsed& parsed, Error& error);

}  // namespace mjforge::expr
