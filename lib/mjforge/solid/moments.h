#pragma once

#include <span>

#include "mjforge/solid/outline.h"

namespace mjforge::solid {

/// The solid between the half planes at the angles 0 and `angle` that an outline in r, z fills as
/// it turns about z (Pappus and Guldinus, for all moments up to the second).
Mass TurnedMass(std::span<const Point> outline, double angle);

}  // namespace mjforge::solid
