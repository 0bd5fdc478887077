// Balance of a body that was lowered onto obstacles: its centre of mass above its contacts.

#pragma once

#include <span>

#include <Eigen/Dense>

#include "mjforge/placing/obstacles.h"

namespace mjforge::placing {

/// Returns true if a body with these shapes does not tip over: its centre of mass, m, is above the
/// convex hull of the contacts that carry it, or beside the hull by at most a twentieth of the
/// body's width (the diagonal of its bounding box, seen from above). All arguments are in one
/// frame, whose z axis points up. The tolerance is for bodies in racks and bowls, which are lowered
/// until they touch one wire or one side first.
bool IsBalanced(std::span<const distance::PlacedShape> shapes, std::span<const Contact> contacts,
                const Eigen::Vector3d& center_of_mass);

}  // namespace mjforge::placing
