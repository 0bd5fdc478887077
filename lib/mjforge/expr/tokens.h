// Tokens of expressions. Private to lib/mjforge/expr.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {

/// The names of the components of a vector: v.x, v.y, v.z, v.w.
inline constexpr std::string_view kComponents = "xyzw";

struct Token {
  enum class Kind { kNumber, kName, kText, kSign, kEnd };

  Kind kind = Kind::kEnd;
  std::size_t offset = 0;  // offset in bytes from the start of the expression's text
  /// Source text; a number includes its unit, a text excludes its quotes.
  std::string_view text = {};
  double number = 0;           // value of a number, without its unit
  std::string_view unit = {};  // unit of a number; empty if it has none

  bool IsSign(std::string_view sign) const { return kind == Kind::kSign && text == sign; }
  bool IsName(std::string_view name) const { return kind == Kind::kName && text == name; }
};

/// Splits `text` into tokens, which refer to `text`. The last token is kEnd. On failure, returns
/// false and sets `error`.
bool Tokenize(std::string_view text, std::vector<Token>& tokens, Error& error);

}  // namespace mjforge::expr
