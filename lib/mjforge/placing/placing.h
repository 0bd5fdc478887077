// Placer, which finds poses of bodies in regions and at sites without overlap, and the distances at
// which placed bodies touch their support.

#pragma once

#include <memory>

#include "mjforge/model/model.h"

namespace mjforge::placing {

/// Height above its support at which an object is tested for overlap, m: larger than rounding
/// errors of numbers in MJCF, so that objects do not overlap. The `margin` of a geom, at which
/// MuJoCo makes contacts without force, is ignored.
inline constexpr double kContactGap = 5e-5;

/// Depth, m, by which a placed object overlaps its support in the end, so that MuJoCo's contacts
/// carry the object from the first step on. An object that starts above its support falls for about
/// two steps, and then penetrates deeper. At that depth, libccd may return a horizontal normal for
/// two meshes with level faces, because it returns the direction to the nearest point of one
/// triangle of the Minkowski difference. `kContactDepth` is larger than the rounding errors of
/// meshes (float), and a fiftieth of the default limit of the check `self_collision`. A box on a
/// box stays at the height `kContactGap`: if the faces of two boxes are parallel to the last digit
/// and overlap by less than 2 um, MuJoCo 2.2 finds deep contacts far outside of the smaller box.
inline constexpr double kContactDepth = 2e-7;

/// Returns a placer. Distances are exact: colliding parts are convex, because MuJoCo replaces a
/// mesh by its convex hull. The visual parts of a body count if none of its parts collides.
std::unique_ptr<model::Placer> MakePlacer();

}  // namespace mjforge::placing
