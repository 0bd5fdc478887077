// Floor on which objects are dropped.
#pragma once

#include <mujoco/mujoco.h>

namespace mjforge::physics {

/// The largest contact margin of any geom, m. Contact forces begin at most at this distance.
double LargestMargin(const mjModel& m);

/// Height from which objects are dropped, m: 2 mm plus the largest margin.
double DropHeight(const mjModel& m);

/// Makes a plane of the world level, with MuJoCo's default contact parameters whatever the file's
/// defaults are, and places it DropHeight() below all colliding geoms.
void LevelFloor(mjModel& m, int geom);

}  // namespace mjforge::physics
