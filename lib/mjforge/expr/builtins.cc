// Tables of the built-in functions, operators and constants of expressions: usage texts, C++
// functions, rules for dimensions.
#include "mjforge/expr/builtins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {
namespace {

constexpr std::array kFunctions = {
    BuiltinInfo{"abs", "abs(x)", "the value without its sign"},
    BuiltinInfo{"acos", "acos(x)", "arc cosine, in rad"},
    BuiltinInfo{"asin", "asin(x)", "arc sine, in rad"},
    BuiltinInfo{"atan", "atan(x)", "arc tangent, in rad"},
    BuiltinInfo{"atan2", "atan2(y, x)", "angle of the point (x, y), in rad"},
    BuiltinInfo{"ceil", "ceil(x)", "x rounded up to a whole number"},
    BuiltinInfo{"clamp", "clamp(x, lo, hi)", "x, but at least lo and at most hi"},
    BuiltinInfo{"cos", "cos(x)", "cosine of an angle in rad"},
    BuiltinInfo{"distance", "distance(a, b)", "distance between two sites, or two points, in m"},
    BuiltinInfo{"exp", "exp(x)", "e to the power of x"},
    BuiltinInfo{"false", "false", "the boolean false"},
    BuiltinInfo{"floor", "floor(x)", "x rounded down to a whole number"},
    BuiltinInfo{"len", "len(list)", "how many values a list has"},
    BuiltinInfo{"lerp", "lerp(a, b, t)", "from a at t = 0 to b at t = 1"},
    BuiltinInfo{"log", "log(x)", "natural logarithm"},
    BuiltinInfo{"max", "max(x, ...)", "the largest of its arguments, or of a list"},
    BuiltinInfo{"min", "min(x, ...)", "the smallest of its arguments, or of a list"},
    BuiltinInfo{"pi", "pi", "3.14159..., half a turn in rad"},
    BuiltinInfo{"round", "round(x)", "the nearest whole number, halves away from 0"},
    BuiltinInfo{"sign", "sign(x)", "-1, 0 or 1"},
    BuiltinInfo{"sin", "sin(x)", "sine of an angle in rad"},
    BuiltinInfo{"sqrt", "sqrt(x)", "square root"},
    BuiltinInfo{"sum", "sum(list, n)", "the sum of a list, or of its first n values"},
    BuiltinInfo{"tan", "tan(x)", "tangent of an angle in rad"},
    BuiltinInfo{"torque", "torque(joint)",
                "the torque that holds what hangs from a hinge or ball joint, in Nm"},
    BuiltinInfo{"true", "true", "the boolean true"},
};

constexpr std::array kConstants = {
    Constant{"false", 0, true},
    Constant{"pi", std::numbers::pi, false},
    Constant{"true", 1, true},
};

// Min() and Max(), unlike std::min and std::max, return NaN if either argument is NaN, because
// callers of Expression::Evaluate() report a result of NaN.
double Min(double a, double b) { return b < a || std::isnan(b) ? b : a; }

double Max(double a, double b) { return b > a || std::isnan(b) ? b : a; }

double Clamp(double x, double lo, double hi) {
  if (!(lo <= hi)) return std::numeric_limits<double>::quiet_NaN();
  return x < lo ? lo : x > hi ? hi : x;
}

double Sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : x; }

using Unary = Builtin::Unary;
using Binary = Builtin::Binary;
using Ternary = Builtin::Ternary;

// Returns `value` as 1 or 0. Returns NaN if `a` or `b`, the operands from which `value` was
// computed, is NaN or infinite.
double Truth(bool value, double a, double b = 0) {
  if (!std::isfinite(a) || !std::isfinite(b)) return std::numeric_limits<double>::quiet_NaN();
  return value ? 1 : 0;
}

// And() and Or() ignore the second operand if the first operand determines the result.
double And(double a, double b) { return a == 0 ? 0 : Truth(b != 0, a, b); }

double Or(double a, double b) { return Truth(a != 0, a) == 1 ? 1 : Truth(b != 0, a, b); }

template <typename Relation>
double Compare(double a, double b) {
  return Truth(Relation()(a, b), a, b);
}

double Choose(double condition, double a, double b) {
  return std::isnan(condition) ? condition : condition == 0 ? b : a;
}

const std::array kUnaryOperators = {
    Builtin{"!", Unary([](double x) { return Truth(x == 0, x); })},
    Builtin{"-", Unary([](double x) { return -x; }), ArgumentRule::kSame, ResultRule::kSame},
};

const std::array kOperators = {
    Builtin{"+", Binary([](double a, double b) { return a + b; }), ArgumentRule::kSame,
            ResultRule::kSame},
    Builtin{"-", Binary([](double a, double b) { return a - b; }), ArgumentRule::kSame,
            ResultRule::kSame},
    Builtin{"*", Binary([](double a, double b) { return a * b; }), ArgumentRule::kAnything,
            ResultRule::kProduct},
    Builtin{"/", Binary([](double a, double b) { return a / b; }), ArgumentRule::kAnything,
            ResultRule::kQuotient},
    // The remainder has the sign of the first operand.
    Builtin{"%", Binary(std::fmod), ArgumentRule::kSame, ResultRule::kSame},
    Builtin{"^", Binary(std::pow), ArgumentRule::kSameAndCount, ResultRule::kPower},
    Builtin{"<", Compare<std::less<double>>, ArgumentRule::kSame, ResultRule::kCount},
    Builtin{"<=", Compare<std::less_equal<double>>, ArgumentRule::kSame, ResultRule::kCount},
    Builtin{">", Compare<std::greater<double>>, ArgumentRule::kSame, ResultRule::kCount},
    Builtin{">=", Compare<std::greater_equal<double>>, ArgumentRule::kSame, ResultRule::kCount},
    Builtin{"==", Compare<std::equal_to<double>>, ArgumentRule::kSame, ResultRule::kCount},
    Builtin{"!=", Compare<std::not_equal_to<double>>, ArgumentRule::kSame, ResultRule::kCount},
    Builtin{"&&", And},
    Builtin{"||", Or},
    Builtin{"?", Choose, ArgumentRule::kSameAfterFirst, ResultRule::kSame},
};

const std::array kBuiltins = {
    Builtin{"abs", Unary(std::fabs), ArgumentRule::kSame, ResultRule::kSame},
    Builtin{"acos", Unary(std::acos), ArgumentRule::kCount, ResultRule::kAngle},
    Builtin{"asin", Unary(std::asin), ArgumentRule::kCount, ResultRule::kAngle},
    Builtin{"atan", Unary(std::atan), ArgumentRule::kCount, ResultRule::kAngle},
    Builtin{"atan2", Binary(std::atan2), ArgumentRule::kSame, ResultRule::kAngle},
    Builtin{"ceil", Unary(std::ceil), ArgumentRule::kSame, ResultRule::kSame},
    Builtin{"clamp", Clamp, ArgumentRule::kSame, ResultRule::kSame},
    Builtin{"cos", Unary(std::cos), ArgumentRule::kAngle, ResultRule::kCount},
    Builtin{"exp", Unary(std::exp), ArgumentRule::kCount, ResultRule::kCount},
    Builtin{"floor", Unary(std::floor), ArgumentRule::kSame, ResultRule::kSame},
    // std::lerp returns exactly a at t = 0 and b at t = 1. The formula a + t * (b - a) can miss b
    // by a rounding error.
    Builtin{"lerp", Ternary(std::lerp), ArgumentRule::kSameAndCount, ResultRule::kSame},
    Builtin{"log", Unary(std::log)},
    Builtin{"max", Max, ArgumentRule::kSame, ResultRule::kSame, true},
    Builtin{"min", Min, ArgumentRule::kSame, ResultRule::kSame, true},
    Builtin{"round", Unary(std::round), ArgumentRule::kSame, ResultRule::kSame},
    Builtin{"sign", Sign},
    Builtin{"sin", Unary(std::sin), ArgumentRule::kAngle, ResultRule::kCount},
    Builtin{"sqrt", Unary(std::sqrt), ArgumentRule::kAnything, ResultRule::kRoot},
    Builtin{"tan", Unary(std::tan), ArgumentRule::kAngle, ResultRule::kCount},
};

}  // namespace

std::span<const BuiltinInfo> Builtins() { return kFunctions; }

const Builtin* FindBuiltin(std::string_view name) {
  return diag::Find(kBuiltins, name, &Builtin::name);
}

const Constant* FindConstant(std::string_view name) {
  return diag::Find(kConstants, name, &Constant::name);
}

const Builtin& UnaryOperator(std::string_view sign) {
  return *diag::Find(kUnaryOperators, sign, &Builtin::name);
}

const Builtin& Operator(std::string_view sign) {
  return *diag::Find(kOperators, sign, &Builtin::name);
}

double Builtin::Call(const std::array<double, 3>& values) const {
  const auto& [a, b, c] = values;
  if (const auto* unary = std::get_if<Unary>(&function)) return (*unary)(a);
  if (const auto* binary = std::get_if<Binary>(&function)) return (*binary)(a, b);
  return std::get<Ternary>(function)(a, b, c);
}

std::string_view UsageOf(std::string_view function) {
  const BuiltinInfo* found = diag::Find(kFunctions, function, &BuiltinInfo::name);
  return found ? found->usage : std::string_view();
}

}  // namespace mjforge::expr
