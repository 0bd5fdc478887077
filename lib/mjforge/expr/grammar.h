#pragma once

// Private to the room.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "mjforge/expr/expr.h"
#include "mjforge/expr/program.h"

namespace mjforge::expr {

/// An expression that has been read.
struct Parsed {
  Program program;
  Type type = Type::kNumber;
  Dimension dimension = {};
  std::vector<Expression::Input> inputs;  // in order of first use
  std::vector<std::string> texts;         // in quotes
  std::set<std::string> formulas;         // called
};

/// What has been read so far of an expression.
struct Typed {
  Operand value;
  Type type = Type::kNumber;
  std::size_t word = 0;  // a text: where it stands
  Dimension dimension = {};
};

/// One of the arguments of a function or an operator.
struct Argument {
  Typed read;
  std::string_view source;  // as written
};

/// What an expression and the functions in it have in common.
struct Parts {
  /// A function, and of each argument its step, its bits, its type, what it measures.
  using Call =
      std::pair<const Formula*, std::vector<std::tuple<int, std::uint64_t, Type, Dimension>>>;

  const Names& names;
  Parsed& parsed;
  Error& error;
  int depth = 0;
  int calls = 0;
  /// What each call gave. Without it, functions that each call another one twice would take 2^n
  /// steps.
  std::map<Call, Typed> made = {};
};

/// Reads and checks `text`. On failure returns false and fills `error`.
bool Parse(std::string_view text, const Names& names, Expression::Result wanted, Parsed& parsed,
           Error& error);

}  // namespace mjforge::expr
