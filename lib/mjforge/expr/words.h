#pragma once

// Private to the room: an expression's text split into words.

#include <cstddef>
#include <string_view>
#include <vector>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {

struct Word {
  enum class Kind { kNumber, kName, kText, kSign, kEnd };

  Kind kind = Kind::kEnd;
  std::size_t offset = 0;  // byte in the expression's text
  /// As written; a number with its unit, a text without its quotes.
  std::string_view text = {};
  double number = 0;           // before the unit is applied
  std::string_view unit = {};  // empty: none

  bool IsSign(std::string_view sign) const { return kind == Kind::kSign && text == sign; }
  bool IsName(std::string_view name) const { return kind == Kind::kName && text == name; }
};

/// Splits `text`, which the words point into; the last word is the end.
/// On failure returns false and fills `error`.
bool SplitWords(std::string_view text, std::vector<Word>& words, Error& error);

}  // namespace mjforge::expr
