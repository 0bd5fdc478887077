// Floor on which objects are dropped, and other fixed geoms on which they can lie.
#pragma once

#include <mujoco/mujoco.h>

namespace mjforge::physics {

/// Returns the largest contact margin of all geoms, m. Contact forces begin at most at this
/// distance.
double LargestMargin(const mjModel& m);

/// Returns the height from which objects are dropped, m: 2 mm plus the largest margin.
double DropHeight(const mjModel& m);

/// Fixed geoms on which objects can lie.
struct Ground {
  int planes = 0;     // number of level planes
  int others = 0;     // number of other fixed geoms
  double height = 0;  // height of the last level plane, m

  bool is_level_floor() const { return planes == 1 && others == 0; }
};
/// Finds the colliding geoms that are fixed to the world. Needs the poses that mj_kinematics
/// computes.
Ground GroundOf(const mjModel& m, const mjData& d);

/// Moves all free bodies up (or down) by the same distance, to put the lowest point of their
/// colliding geoms at `height`, m. Needs the poses that mj_kinematics computes. Returns false if
/// the free bodies have no colliding geoms, because they would fall for ever.
bool LiftFreeBodies(const mjModel& m, mjData& d, double height);

/// Makes a plane of the world level, with MuJoCo's default contact parameters whatever the file's
/// defaults are, and places the plane DropHeight() below all colliding geoms.
void LevelFloor(mjModel& m, int geom);

}  // namespace mjforge::physics
