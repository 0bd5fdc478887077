#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/physics/physics.h"

namespace mjforge::physics {

/// How far an object that rests on a level floor can be tilted before it topples.
struct Margin {
  Result::Stability least;
  double azimuth = 0;  // rad, from x towards y: the way it topples first
};

/// From the hull of all that collides of the tree of body `root`, and its centre of mass, as
/// mj_kinematics and mj_comPos left them: as it is tilted, its centre rises over the floor up to
/// the angle where it topples, by the height that costs the energy. Looks every 0.5 deg along 72
/// ways. Both are 0 for what rolls or stands on a point. It lies up to `sink` (m) in the floor,
/// more at one end than at the other: rising or falling by less means nothing.
Margin MarginOf(const mjModel& m, const mjData& d, int root, double sink);

}  // namespace mjforge::physics
