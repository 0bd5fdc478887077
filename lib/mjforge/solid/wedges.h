#pragma once

#include <vector>

#include "mjforge/solid/convex.h"

namespace mjforge::solid {

/// The pieces of a turned outline: a convex polygon with a side on the axis that widens nowhere
/// towards it is one; any other is a wedge for each facet. Corners of what faces away from the axis
/// lie on the true circle, or the walls would get thin, around it; those of what faces the axis are
/// so far out that the middle of the facet lies on it.
std::vector<Piece> TurnedPieces(const Outline& outline, const Partition& partition, double angle,
                                int facets);

}  // namespace mjforge::solid
