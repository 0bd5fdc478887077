#pragma once

#include <mujoco/mujoco.h>

namespace mjforge::physics {

/// The largest distance at which MuJoCo already pushes, m.
double LargestMargin(const mjModel& m);

/// The height from which things are dropped, m: 2 mm more.
double DropHeight(const mjModel& m);

/// Makes a geom of the world the floor: level, with MuJoCo's own contact parameters whatever the
/// file's defaults say, and DropHeight() below everything that can collide.
void LevelFloor(mjModel& m, int geom);

}  // namespace mjforge::physics
