// The geometry of placing bodies: footprints, free play in regions, contact, overlap, stable poses.

#pragma once

#include <memory>

#include "mjforge/model/model.h"

namespace mjforge::placing {

/// Height of a placed object above its support, m: less than 0.1 mm, so that the object hardly
/// falls, and larger than rounding errors of numbers in MJCF, so that objects do not overlap. The
/// `margin` of a geom, at which MuJoCo makes contacts without force, is ignored.
inline constexpr double kContactGap = 5e-5;

/// Returns a placer. Distances are exact: colliding parts are convex, because MuJoCo replaces a
/// mesh by its convex hull. The visual parts of a body count if none of its parts collides.
std::unique_ptr<model::Placer> MakePlacer();

}  // namespace mjforge::placing
