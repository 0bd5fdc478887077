// Built-in functions, operators and constants of expressions. Private to lib/mjforge/expr.
#pragma once

#include <array>
#include <string_view>
#include <variant>

namespace mjforge::expr {

/// Dimensions that a built-in function requires of its arguments. kSame: all arguments have one
/// common dimension. kSameAndCount: all but the last have one common dimension, and the last is a
/// plain number. kSameAfterFirst: all but the first have one common dimension.
enum class ArgumentRule { kAnything, kSame, kSameAndCount, kSameAfterFirst, kCount, kAngle };
/// Dimension of a built-in function's result. kSame: the common dimension of the arguments.
enum class ResultRule { kSame, kCount, kAngle, kProduct, kQuotient, kPower, kRoot };

/// A built-in function or operator.
struct Builtin {
  using Unary = double (*)(double);
  using Binary = double (*)(double, double);
  using Ternary = double (*)(double, double, double);

  std::string_view name;
  std::variant<Unary, Binary, Ternary> function;
  ArgumentRule argument_rule = ArgumentRule::kAnything;
  ResultRule result_rule = ResultRule::kCount;
  bool is_variadic = false;  // accepts one or more arguments: f(a, b, c) is f(f(a, b), c)

  /// Number of arguments; 0 for a variadic function.
  int arity() const { return is_variadic ? 0 : static_cast<int>(function.index()) + 1; }
  /// Calls the function with the first numbers of `values`: one, two or three, depending on the
  /// function.
  double Call(const std::array<double, 3>& values) const;
};

/// Returns the function with this name; null if there is none.
const Builtin* FindBuiltin(std::string_view name);
/// Returns the operator with one operand: "-" or "!".
const Builtin& UnaryOperator(std::string_view sign);
/// Returns the operator with two operands ("+", "<", "&&", ...) or three ("?").
const Builtin& Operator(std::string_view sign);

/// The constants `pi`, `true` and `false`.
struct Constant {
  std::string_view name;
  double value;
  bool is_boolean;
};
/// Returns the constant with this name; null if there is none.
const Constant* FindConstant(std::string_view name);

/// Returns the usage of a built-in function ("clamp(x, lo, hi)"); an empty text for other names.
std::string_view UsageOf(std::string_view function);

}  // namespace mjforge::expr
