// The geometry of placing bodies: footprints, free play in regions, contact, overlap, stable poses.

#pragma once

#include <memory>

#include "mjforge/model/model.h"

namespace mjforge::placing {

/// Height above its support at which an object is tested for overlap, m: larger than rounding
/// errors of numbers in MJCF, so that objects do not overlap. The `margin` of a geom, at which
/// MuJoCo makes contacts without force, is ignored.
inline constexpr double kContactGap = 5e-5;

/// Depth in its support to which a placed object is lowered in the end, m, so that MuJoCo's
/// contacts carry the object from the first step on. An object that starts above its support
/// strikes it with the speed of two steps. At the depth of such a stroke, libccd may return a
/// horizontal normal for two meshes whose faces are level: it returns the direction to the nearest
/// point of one triangle of the Minkowski difference, and the depth decides if that triangle is
/// above the contact. The depth here is larger than rounding errors of meshes (float), and a
/// fiftieth of `self_collision`. A box on a box stays at the height `kContactGap`: if their faces
/// are parallel to the last digit and less than 2 um in each other, MuJoCo 2.2 finds deep contacts
/// far outside of the smaller box.
inline constexpr double kContactDepth = 2e-7;

/// Returns a placer. Distances are exact: colliding parts are convex, because MuJoCo replaces a
/// mesh by its convex hull. The visual parts of a body count if none of its parts collides.
std::unique_ptr<model::Placer> MakePlacer();

}  // namespace mjforge::placing
