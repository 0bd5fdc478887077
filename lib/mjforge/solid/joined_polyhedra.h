// Convex polyhedra that share faces: joining of pairs with a convex union, and the number of
// connected components.

#pragma once

#include <cstddef>
#include <vector>

#include "mjforge/solid/polytope.h"

namespace mjforge::solid {

/// Joins pairs of polyhedra whose union is convex until there are no more such pairs. Pairs with
/// the largest common faces come first. `near`, m, is the tolerance for points on a plane.
void JoinPolyhedra(std::vector<Polytope>& polyhedra, double near);

/// Returns the number of connected components. Two polyhedra are connected if two of their faces
/// share an area, not only an edge or a point. Points up to `near`, m, from a plane count as on the
/// plane.
std::size_t CountSeparateParts(const std::vector<Polytope>& polyhedra, double near);

}  // namespace mjforge::solid
