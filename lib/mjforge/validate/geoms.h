#ifndef MJFORGE_VALIDATE_GEOMS_H_
#define MJFORGE_VALIDATE_GEOMS_H_

// Compiled geoms in the words of the model.

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"

namespace mjforge::validate {

/// The number `id` of a list of positions and one of quaternions.
model::Pose PoseAt(const mjtNum* pos, const mjtNum* quat, int id);

/// Whether a geom belongs to a body but the world and its bits let it collide.
bool CollidesInBody(const mjModel& m, int geom);

/// The exact box around a geom at a pose. Empty for planes and height fields,
/// which belong to scenes.
model::Box3 GeomBox(const mjModel& m, int geom, const model::Pose& X_AG);

}  // namespace mjforge::validate

#endif  // MJFORGE_VALIDATE_GEOMS_H_
