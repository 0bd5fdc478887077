// Static stability of an object that rests on a level floor: how far it can tilt before it topples.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/physics/physics.h"

namespace mjforge::physics {

struct StabilityMargin {
  Result::Stability least;
  double azimuth = 0;  // rad, from x towards y: direction in which the object topples first
};

/// Computes the margin from the convex hull of the colliding geoms of a tree of bodies and its
/// centre of mass, as mj_kinematics and mj_comPos computed them. While the object tilts, its centre
/// of mass rises until the object topples; the energy is the weight times this rise. Tries steps of
/// 0.5 deg in 72 directions. Angle and energy are 0 if the object rolls or stands on a point.
/// Contacts are up to `sink` (m) deep, more at one end than at the other, so that smaller changes
/// of the height are ignored.
StabilityMargin FindStabilityMargin(const mjModel& m, const mjData& d, int root, double sink);

}  // namespace mjforge::physics
