#pragma once

// Private to the room: what the functions of the language compute.

#include <string_view>
#include <variant>

namespace mjforge::expr {

using Callable = std::variant<double (*)(double), double (*)(double, double),
                              double (*)(double, double, double), double (*)(const double*, int)>;

struct Callee {
  std::string_view name;
  Callable callable;

  /// How many arguments it takes; 0: one or more.
  int arity() const {
    const auto index = static_cast<int>(callable.index());
    return index == 3 ? 0 : index + 1;
  }
};

/// Also finds the unary operators, under the names "-" and "!"; null if there is no function of
/// that name.
const Callee* FindCallee(std::string_view name);

/// The value of `pi`, `true`, `false`; null if `name` is not a constant.
struct Constant {
  std::string_view name;
  double value;
  bool is_boolean;
};
const Constant* FindConstant(std::string_view name);

/// The remainder of a division, with the sign of `a`, as C's fmod.
double Remainder(double a, double b);

/// How a function is written ("clamp(x, lo, hi)").
std::string_view UsageOf(std::string_view function);

}  // namespace mjforge::expr
