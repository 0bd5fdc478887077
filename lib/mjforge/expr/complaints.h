#pragma once

// Private to the room: the messages about words that do not fit.

#include <cstddef>
#include <span>
#include <string_view>

#include "mjforge/expr/expr.h"
#include "mjforge/expr/words.h"

namespace mjforge::expr {

inline constexpr std::string_view kSplitHint =
    "move a part of it into a parameter: a parameter may be an expression";

/// A word where an operand should be.
Error MissingValue(std::span<const Word> words, std::size_t at);
/// A word that cannot follow what came before it.
Error Unexpected(std::span<const Word> words, std::size_t at, const Names& names);
/// An undefined name, or a function's name without parentheses. `beside_text`: it is compared with
/// a text.
Error UnknownName(const Word& word, const Names& names, bool beside_text);
/// A name with parentheses that is not a function.
Error NotAFunction(const Word& word, const Names& names);
Error UnknownUnit(const Word& word, const Names& names);
/// A component a variable does not have (`component` empty: a vector used whole).
Error WrongComponent(const Word& word, const Names::Variable& variable, std::string_view component);

/// A list where a single value should be.
Error WholeList(const Word& word);
/// Something else where a list should be. `usage`: how the function is written.
Error NotAList(const Word& word, std::string_view usage);
/// A vector of `count` components has none of this number.
Error NoSuchElement(const Word& word, double index, int count);
/// A text that is not an operand of == or !=.
Error MisusedText(const Word& word);
/// A text compared with a number or a boolean.
Error TextAgainst(const Word& word);
/// A text that is one side of a choice whose other side is none.
Error TextBeside(const Word& word);
/// A function with `count` arguments where it takes `arity`, 0 for one or more.
Error WrongCount(const Word& function, int arity, int count, std::string_view usage);
Error TooManyCalls(const Word& function, int limit);
Error TooLong(std::size_t bytes, std::size_t limit);
Error TooDeep(const Word& word, int limit);

}  // namespace mjforge::expr
