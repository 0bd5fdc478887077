#include "mjforge/expr/functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {
namespace {

constexpr std::array kFunctions = {
    Function{"abs", "abs(x)", "the value without its sign"},
    Function{"acos", "acos(x)", "arc cosine, in rad"},
    Function{"asin", "asin(x)", "arc sine, in rad"},
    Function{"atan", "atan(x)", "arc tangent, in rad"},
    Function{"atan2", "atan2(y, x)", "angle of the point (x, y), in rad"},
    Function{"ceil", "ceil(x)", "x rounded up to a whole number"},
    Function{"clamp", "clamp(x, lo, hi)", "x, but at least lo and at most hi"},
    Function{"cos", "cos(x)", "cosine of an angle in rad"},
    Function{"exp", "exp(x)", "e to the power of x"},
    Function{"false", "false", "the boolean false"},
    Function{"floor", "floor(x)", "x rounded down to a whole number"},
    Function{"len", "len(list)", "how many values a list has"},
    Function{"lerp", "lerp(a, b, t)", "from a at t = 0 to b at t = 1"},
    Function{"log", "log(x)", "natural logarithm"},
    Function{"max", "max(x, ...)", "the largest of its arguments, or of a list"},
    Function{"min", "min(x, ...)", "the smallest of its arguments, or of a list"},
    Function{"pi", "pi", "3.14159..., half a turn in rad"},
    Function{"round", "round(x)", "the nearest whole number, halves away from 0"},
    Function{"sign", "sign(x)", "-1, 0 or 1"},
    Function{"sin", "sin(x)", "sine of an angle in rad"},
    Function{"sqrt", "sqrt(x)", "square root"},
    Function{"sum", "sum(list, n)", "the sum of a list, or of its first n values"},
    Function{"tan", "tan(x)", "tangent of an angle in rad"},
    Function{"true", "true", "the boolean true"},
};

constexpr std::array kConstants = {
    Constant{"false", 0, true},
    Constant{"pi", std::numbers::pi, false},
    Constant{"true", 1, true},
};

// A NaN among the arguments is the result: it must not be lost on the way to
// the place where it is reported.
double Least(double a, double b) { return b < a || std::isnan(b) ? b : a; }

double Most(double a, double b) { return b > a || std::isnan(b) ? b : a; }

double Clamp(double x, double lo, double hi) {
  if (std::isnan(lo) || std::isnan(hi)) return lo + hi;
  return x < lo ? lo : x > hi ? hi : x;
}

// Exact at both ends, which a + t * (b - a) is not.
double Lerp(double a, double b, double t) { return std::lerp(a, b, t); }

double Sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : x; }

using One = Callee::One;
using Two = Callee::Two;

// What is not a number, or infinite, is neither true nor false.
double Truth(bool value, double a, double b = 0) {
  if (!std::isfinite(a) || !std::isfinite(b)) return std::numeric_limits<double>::quiet_NaN();
  return value ? 1 : 0;
}

// What the first one settles does not need the second.
double And(double a, double b) { return a == 0 ? 0 : Truth(b != 0, a, b); }

double Or(double a, double b) { return Truth(a != 0, a) == 1 ? 1 : Truth(b != 0, a, b); }

double Choose(double condition, double a, double b) {
  return std::isnan(condition) ? condition : condition == 0 ? b : a;
}

const std::array kUnaryOperators = {
    Callee{"!", One([](double x) { return Truth(x == 0, x); })},
    Callee{"-", One([](double x) { return -x; }), Takes::kSame, Gives::kSame},
};

const std::array kOperators = {
    Callee{"+", Two([](double a, double b) { return a + b; }), Takes::kSame, Gives::kSame},
    Callee{"-", Two([](double a, double b) { return a - b; }), Takes::kSame, Gives::kSame},
    Callee{"*", Two([](double a, double b) { return a * b; }), Takes::kAnything, Gives::kProduct},
    Callee{"/", Two([](double a, double b) { return a / b; }), Takes::kAnything, Gives::kQuotient},
    // The remainder with the sign of `a`.
    Callee{"%", Two(std::fmod), Takes::kSame, Gives::kSame},
    Callee{"^", Two(std::pow), Takes::kSameAndCount, Gives::kPower},
    Callee{"<", Two([](double a, double b) { return Truth(a < b, a, b); }), Takes::kSame,
           Gives::kCount},
    Callee{"<=", Two([](double a, double b) { return Truth(a <= b, a, b); }), Takes::kSame,
           Gives::kCount},
    Callee{">", Two([](double a, double b) { return Truth(a > b, a, b); }), Takes::kSame,
           Gives::kCount},
    Callee{">=", Two([](double a, double b) { return Truth(a >= b, a, b); }), Takes::kSame,
           Gives::kCount},
    Callee{"==", Two([](double a, double b) { return Truth(a == b, a, b); }), Takes::kSame,
           Gives::kCount},
    Callee{"!=", Two([](double a, double b) { return Truth(a != b, a, b); }), Takes::kSame,
           Gives::kCount},
    Callee{"&&", And},
    Callee{"||", Or},
    Callee{"?", Choose, Takes::kSameAfterFirst, Gives::kSame},
};

const std::array kCallees = {
    Callee{"abs", One(std::fabs), Takes::kSame, Gives::kSame},
    Callee{"acos", One(std::acos), Takes::kCount, Gives::kAngle},
    Callee{"asin", One(std::asin), Takes::kCount, Gives::kAngle},
    Callee{"atan", One(std::atan), Takes::kCount, Gives::kAngle},
    Callee{"atan2", Two(std::atan2), Takes::kSame, Gives::kAngle},
    Callee{"ceil", One(std::ceil), Takes::kSame, Gives::kSame},
    Callee{"clamp", Clamp, Takes::kSame, Gives::kSame},
    Callee{"cos", One(std::cos), Takes::kAngle, Gives::kCount},
    Callee{"exp", One(std::exp), Takes::kCount, Gives::kCount},
    Callee{"floor", One(std::floor), Takes::kSame, Gives::kSame},
    Callee{"lerp", Lerp, Takes::kSameAndCount, Gives::kSame},
    Callee{"log", One(std::log)},
    Callee{"max", Most, Takes::kSame, Gives::kSame, true},
    Callee{"min", Least, Takes::kSame, Gives::kSame, true},
    Callee{"round", One(std::round), Takes::kSame, Gives::kSame},
    Callee{"sign", Sign},
    Callee{"sin", One(std::sin), Takes::kAngle, Gives::kCount},
    Callee{"sqrt", One(std::sqrt), Takes::kAnything, Gives::kRoot},
    Callee{"tan", One(std::tan), Takes::kAngle, Gives::kCount},
};

template <typename Table>
auto FindIn(const Table& table, std::string_view name) -> decltype(table.data()) {
  const auto found =
      std::find_if(table.begin(), table.end(), [name](const auto& e) { return e.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace

std::span<const Function> Functions() { return kFunctions; }

const Callee* FindCallee(std::string_view name) { return FindIn(kCallees, name); }

const Constant* FindConstant(std::string_view name) { return FindIn(kConstants, name); }

const Callee& UnaryOperator(std::string_view sign) { return *FindIn(kUnaryOperators, sign); }

const Callee& Operator(std::string_view sign) { return *FindIn(kOperators, sign); }

double Callee::Call(const std::array<double, 3>& values) const {
  const auto& [a, b, c] = values;
  if (const auto* one = std::get_if<One>(&function)) return (*one)(a);
  if (const auto* two = std::get_if<Two>(&function)) return (*two)(a, b);
  return std::get<Three>(function)(a, b, c);
}

std::string_view UsageOf(std::string_view function) {
  const Function* found = FindIn(kFunctions, function);
  return found ? found->usage : std::string_view();
}

}  // namespace mjforge::expr
