// The table of units that can follow a number.
#include <array>
#include <numbers>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {
namespace {

constexpr Dimension kLength = {1, 0, 0};
constexpr Dimension kMass = {0, 1, 0};
constexpr Dimension kTime = {0, 0, 1};

// Units of length come first, because the hint for a misspelled unit suggests the first of several
// equally similar names.
constexpr std::array kUnits = {
    Unit{"mm", "millimetre, 0.001 m", kLength, 1, 1000},
    Unit{"cm", "centimetre, 0.01 m", kLength, 1, 100},
    Unit{"m", "metre", kLength},
    Unit{"km", "kilometre, 1000 m", kLength, 1000},
    Unit{"um", "micrometre, 0.000001 m", kLength, 1, 1e6},
    Unit{"deg", "degree, pi/180 rad", Dimension::Angle(), std::numbers::pi, 180},
    Unit{"rad", "radian", Dimension::Angle()},
    Unit{"g", "gram, 0.001 kg", kMass, 1, 1000},
    Unit{"kg", "kilogram", kMass},
    Unit{"s", "second", kTime},
    Unit{"ms", "millisecond, 0.001 s", kTime, 1, 1000},
    Unit{"N", "newton", {1, 1, -2}},
    Unit{"Nm", "newton metre", {2, 1, -2}},
};

}  // namespace

std::span<const Unit> Units() { return kUnits; }

const Unit* FindUnitSuffix(std::string_view name) { return diag::Find(kUnits, name, &Unit::name); }

}  // namespace mjforge::expr
