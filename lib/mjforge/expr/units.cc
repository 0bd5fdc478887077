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

constexpr Dimension kLength = {1, 0, 0};
constexpr Dimension kMass = {0, 1, 0};
constexpr Dimension kTime = {0, 0, 1};
constexpr Dimension kAngle = {0, 0, 0, 1};

// In the order of kUnits.
constexpr std::array<KnownUnit, kUnits.size()> kKnownUnits = {{
    {kLength, 1, 1000},  // mm
    {kLength, 1, 100},   // cm
    {kLength, 1, 1},     // m
    {kLength, 1000, 1},  // km
    {kLength, 1, 1e6},   // um
    {kAngle, std::numbers::pi, 180},
    {kAngle, 1, 1},      // rad
    {kMass, 1, 1000},    // g
    {kMass, 1, 1},       // kg
    {kTime, 1, 1},       // s
    {kTime, 1, 1000},    // ms
    {{1, 1, -2}, 1, 1},  // N
    {{2, 1, -2}, 1, 1},  // Nm
}};

}  // namespace

std::span<const Unit> Units() { return kUnits; }

std::optional<KnownUnit> FindKnownUnit(std::string_view unit) {
  const auto found = std::ranges::find(kUnits, unit, &Unit::name);
  if (found == kUnits.end()) return std::nullopt;
  return kKnownUnits[static_cast<std::size_t>(found - kUnits.begin())];
}

}  // namespace mjforge::expr
