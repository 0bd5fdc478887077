#ifndef MJFORGE_PHYSICS_TOUCHING_H_
#define MJFORGE_PHYSICS_TOUCHING_H_

#include <vector>

#include "mjforge/physics/subject.h"

namespace mjforge::physics {

/// Are two solids of a body no farther apart than `gap`, m? Meshes count as
/// their convex hulls. To about a thousandth of the solids' size.
bool Touch(const Solid& a, const Solid& b, double gap);

/// The solids of a body in groups that hold together, as numbers in
/// body.solids; the heaviest group first.
std::vector<std::vector<std::size_t>> Pieces(const RigidBody& body, double gap);

/// Is the body's centre of mass in the convex hull of its solids, or nearer to it
/// than a thousandth of their size?
bool CenterOfMassIsInside(const RigidBody& body);

}  // namespace mjforge::physics

#endif  // MJFORGE_PHYSICS_TOUCHING_H_
