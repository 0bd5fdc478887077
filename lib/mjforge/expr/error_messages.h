// Errors of expressions: one function per message. Private to lib/mjforge/expr.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "mjforge/expr/expr.h"
#include "mjforge/expr/tokens.h"

namespace mjforge::expr {

inline constexpr std::string_view kSplitHint =
    "move a part of it into a parameter: a parameter may be an expression";

/// Returns the error for a missing operand: the token at index `at` cannot begin an operand.
Error MissingValue(std::span<const Token> tokens, std::size_t at);
/// Returns the error for the token at index `at`, which cannot follow the operand before it.
Error Unexpected(std::span<const Token> tokens, std::size_t at, const SymbolTable& names);
/// Returns the error for an undefined name, or for the name of a function without parentheses.
/// `beside_text` is true if the name is compared with a text.
Error UnknownName(const Token& token, const SymbolTable& names, bool beside_text);
/// Returns the error for a name that is followed by "(" but is not the name of a function.
Error NotAFunction(const Token& token, const SymbolTable& names);
Error UnknownUnit(const Token& token, const SymbolTable& names);
/// Returns the error for a chained comparison `left < middle < ...`; `sign` is the second
/// comparison sign.
Error ChainedComparison(std::string_view left, std::string_view middle, const Token& sign);
/// Returns the error for a component that a variable does not have. `component` is empty if the
/// name of a vector is used without a component.
Error WrongComponent(const Token& token, const SymbolTable::Variable& variable,
                     std::string_view component);

/// Returns the error for the name of a list where a single value is required.
Error WholeList(const Token& token);
/// Returns the error for an argument that must be a list. `usage` is the usage of the function
/// ("sum(list, n)").
Error NotAList(const Token& token, std::string_view usage);
/// Returns the error for an argument that must be a name. `usage` is the usage of the function.
Error NotAName(const Token& token, std::string_view usage);
/// Returns the error for an argument of torque() that is not the name of a joint whose torque the
/// expression can use.
Error UnknownJoint(const Token& token, const SymbolTable& names);
/// Returns the error for an argument of distance() that names neither a site nor a vector of three
/// numbers.
Error UnknownPoint(const Token& token, const SymbolTable& names);
/// Returns the error for an index that is invalid for a vector of `count` components.
Error NoSuchElement(const Token& token, double index, int count);
/// Returns the error for a text that is used in place of a number or a boolean.
Error MisusedText(const Token& token);
/// Returns the error for a text compared with a number or a boolean.
Error TextAgainst(const Token& token);
/// Returns the error for a choice (? :) between a text and a value that is not a text.
Error TextBeside(const Token& token);
/// Returns the error for a call with `count` arguments of a function that takes `arity` arguments.
/// An `arity` of 0 means one or more.
Error WrongCount(const Token& function, int arity, int count, std::string_view usage);
Error TooManyCalls(const Token& function, int limit);
Error TooLong(std::size_t bytes, std::size_t limit);
Error TooDeep(const Token& token, int limit);

}  // namespace mjforge::expr
