// Built-in functions, operators and constants of expressions. Private to lib/mjforge/expr.
#pragma once

#include <array>
#include <string_view>
#include <variant>

namespace mjforge::expr {

/// Dimensions that a built-in function or operator requires of its arguments. kSame: all arguments
/// have one common dimension. kSameAndCount: the last argument is a plain number, all others have
/// one common dimension. kSameAfterFirst: all arguments except the first have one common dimension.
/// kCount: the only argument is a plain number. kAngle: the only argument is an angle in rad. Plain
/// numbers and numbers of unknown dimension satisfy every rule.
enum class ArgumentRule { kAnything, kSame, kSameAndCount, kSameAfterFirst, kCount, kAngle };
/// Dimension of the result of a built-in function or operator. kSame: the common dimension that the
/// ArgumentRule determines. kCount: a plain number. kProduct, kQuotient, kPower: the product,
/// quotient or power of the two arguments' dimensions. kRoot: the square root of the argument's
/// dimension.
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
  /// Calls `function` with the first one, two or three numbers of `values`, depending on the number
  /// of its parameters.
  double Call(const std::array<double, 3>& values) const;
};

/// Returns the built-in function with this name; null if there is none. Does not find `len`, `sum`,
/// `torque` and `distance`, whose first argument is a name.
const Builtin* FindBuiltin(std::string_view name);
/// Returns the operator with one operand. `sign` must be "-" or "!".
const Builtin& UnaryOperator(std::string_view sign);
/// Returns the operator with two operands ("+", "<", "&&", ...) or three ("?"). `sign` must be the
/// sign of such an operator.
const Builtin& Operator(std::string_view sign);

/// The constants `pi`, `true` and `false`.
struct Constant {
  std::string_view name;
  double value;
  bool is_boolean;
};
/// Returns the constant with this name; null if there is none.
const Constant* FindConstant(std::string_view name);

/// Returns the usage of a built-in function or constant ("clamp(x, lo, hi)"); an empty text for
/// other names.
std::string_view UsageOf(std::string_view function);

}  // namespace mjforge::expr
