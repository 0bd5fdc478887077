#pragma once

// Private to the room: what the functions of the language compute.

#include <array>
#include <string_view>
#include <variant>

namespace mjforge::expr {

/// What the arguments of a function must measure.
enum class Takes { kAnything, kSame, kSameAndCount, kSameAfterFirst, kCount, kAngle };
/// What its result measures, by its arguments.
enum class Gives { kSame, kCount, kAngle, kProduct, kQuotient, kPower, kRoot };

/// A function, or an operator.
struct Callee {
  using One = double (*)(double);
  using Two = double (*)(double, double);
  using Three = double (*)(double, double, double);

  std::string_view name;
  std::variant<One, Two, Three> function;
  Takes takes = Takes::kAnything;
  Gives gives = Gives::kCount;
  bool repeats = false;  // takes one or more: f(f(a, b), c)

  /// How many arguments it takes; 0: one or more.
  int arity() const { return repeats ? 0 : static_cast<int>(function.index()) + 1; }
  /// With as many of the values as the function takes.
  double Call(const std::array<double, 3>& values) const;
};

/// Null if there is no function of that name.
const Callee* FindCallee(std::string_view name);
/// Of one operand: "-" and "!".
const Callee& UnaryOperator(std::string_view sign);
/// Of two: "+", "<", "&&", ...; "?" of three.
const Callee& Operator(std::string_view sign);

/// The value of `pi`, `true`, `false`; null if `name` is not a constant.
struct Constant {
  std::string_view name;
  double value;
  bool is_boolean;
};
const Constant* FindConstant(std::string_view name);

/// How a function is written ("clamp(x, lo, hi)").
std::string_view UsageOf(std::string_view function);

}  // namespace mjforge::expr
