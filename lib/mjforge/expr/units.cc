#include "mjforge/expr/units.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {
namespace {

// Lengths first: of two names equally near to a slip, the first is suggested.
constexpr std::array kUnits = {
    Unit{"mm", "millimetre, 0.001 m"},
    Unit{"cm", "centimetre, 0.01 m"},
    Unit{"m", "metre"},
    Unit{"km", "kilometre, 1000 m"},
    Unit{"um", "micrometre, 0.000001 m"},
    Unit{"deg", "degree, pi/180 rad"},
    Unit{"rad", "radian"},
    Unit{"g", "gram, 0.001 kg"},
    Unit{"kg", "kilogram"},
    Unit{"s", "second"},
    Unit{"ms", "millisecond, 0.001 s"},
    Unit{"N", "newton"},
    Unit{"Nm", "newton metre"},
};

// Two whole numbers rather than a factor: 15 / 1000 is the double nearest to
// 0.015, 15 * 0.001 is not.
struct Ratio {
  double numerator;
  double denominator;
};

// In the order of kUnits.
constexpr std::array<Ratio, kUnits.size()> kRatios = {{
    {1, 1000},  // mm
    {1, 100},   // cm
    {1, 1},     // m
    {1000, 1},  // km
    {1, 1e6},   // um
    {std::numbers::pi, 180},
    {1, 1},     // rad
    {1, 1000},  // g
    {1, 1},     // kg
    {1, 1},     // s
    {1, 1000},  // ms
    {1, 1},     // N
    {1, 1},     // Nm
}};

}  // namespace

std::span<const Unit> Units() { return kUnits; }

std::optional<double> InSi(double value, std::string_view unit) {
  const auto found = std::find_if(kUnits.begin(), kUnits.end(),
                                  [unit](const Unit& each) { return each.name == unit; });
  if (found == kUnits.end()) return std::nullopt;
  const Ratio ratio = kRatios[static_cast<std::size_t>(found - kUnits.begin())];
  return value * ratio.numerator / ratio.denominator;
}

}  // namespace mjforge::expr
