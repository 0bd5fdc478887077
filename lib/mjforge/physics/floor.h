#ifndef MJFORGE_PHYSICS_FLOOR_H_
#define MJFORGE_PHYSICS_FLOOR_H_

#include <mujoco/mujoco.h>

namespace mjforge::physics {

/// From how high things are dropped, m: more than the margins within which MuJoCo pushes already.
double DropHeight(const mjModel& m);

/// Makes a geom of the world the floor: level, with MuJoCo's own contact parameters whatever
/// the file's defaults say, and below all that can collide by DropHeight().
void LevelFloor(mjModel& m, int geom);

}  // namespace mjforge::physics

#endif  // MJFORGE_PHYSICS_FLOOR_H_
