// Result of parsing an expression, and the entry point of the parser. Private to lib/mjforge/expr.
#pragma once

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

/// A parsed expression.
struct ParsedExpression {
  Program program;
  Type type = Type::kNumber;
  Dimension dimension = {};
  std::vector<Expression::Input> inputs;  // in order of first use
  std::vector<std::string> texts;         // texts in quotes
  std::set<std::string> functions;        // names of the spec's functions that are called
};

/// Operand with its type and dimension: the result of a parsed part of an expression.
struct TypedOperand {
  Operand value;
  Type type = Type::kNumber;
  std::size_t token = 0;  // index of the token of a text operand, for errors
  Dimension dimension = {};
};

/// Argument of a function, or operand of an operator.
struct Argument {
  TypedOperand operand;
  std::string_view source;  // source text of the argument; may be empty

  Dimension dimension() const {
    return operand.type == Type::kNumber ? operand.dimension : Dimension::Count();
  }
};

/// State that the parser of an expression shares with the parsers of the bodies of the spec
/// functions that the expression calls.
struct ParseState {
  /// Identifies a call: the function and, for each argument, the index of its step in the program,
  /// the bits of its constant, its type and its dimension.
  using Call =
      std::pair<const SpecFunction*, std::vector<std::tuple<int, std::uint64_t, Type, Dimension>>>;

  const SymbolTable& names;
  ParsedExpression& parsed;
  Error& error;
  int depth = 0;
  int calls = 0;
  /// Results of earlier calls. A call with the same arguments is not expanded again. A chain of n
  /// functions, each of which calls the next one twice in the same way, then takes n expansions
  /// instead of 2^n.
  std::map<Call, TypedOperand> results = {};
};

/// Parses and checks `text`, and sets `parsed`. On failure, returns false and sets `error`.
bool Parse(std::string_view text, const SymbolTable& names, Expression::Result wanted,
           ParsedExpression& parsed, Error& error);

}  // namespace mjforge::expr
