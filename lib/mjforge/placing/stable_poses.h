// Stable poses of a body on a level plane.

#pragma once

#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::placing {

/// Returns the poses in which a body, with all bodies below it, rests on a face of its convex hull
/// with its centre of mass above that face. Faces between which the body rolls (round sides) are
/// one pose. The probability of a pose is the solid angle of its faces, seen from the centre of
/// mass, as a share of the sum over all poses. A pose is named after the side that is down; `front`
/// is the angle of the body's front, from its -y axis, rad.
std::vector<model::StablePose> StablePosesOf(const model::Object& object, int body, double front);

}  // namespace mjforge::placing
