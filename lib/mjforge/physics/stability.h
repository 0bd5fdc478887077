// Static stability of an object that rests on a level floor: how far it can tilt before it topples.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/physics/physics.h"

namespace mjforge::physics {

/// Least tilt that topples an object, least energy, and the direction of the least tilt.
struct StabilityMargin {
  Result::Stability least;
  double azimuth = 0;  // rad, from x towards y: direction in which the object topples first
};

/// Returns the margin of a tree of bodies that stands on a level floor, from the convex hull of its
/// colliding geoms and its centre of mass, at the poses that mj_kinematics and mj_comPos computed.
/// While the object tilts, the centre of mass rises until the object topples; the energy is the
/// weight times this rise. Tries tilts in steps of 0.5 deg, in 72 directions. Angle and energy are
/// 0 if the object rolls or stands on a point. At small tilts, ignores changes of the height by
/// less than `sink`, m, because contacts are up to `sink` deep, and deeper at one end of the object
/// than at the other.
StabilityMargin FindStabilityMargin(const mjModel& m, const mjData& d, int root, double sink);

}  // namespace mjforge::physics
