// Convex pieces of a lathe (a solid of revolution), with which the lathe collides.

#pragma once

#include <vector>

#include "mjforge/solid/convex_partition.h"

namespace mjforge::solid {

/// Makes the convex pieces of a revolved outline from the convex polygons of its partition. A
/// polygon becomes one piece if it has a side on the axis and no other side faces the axis;
/// otherwise it becomes a wedge, which is repeated for each facet. Corners that face away from the
/// axis are on the true circle or, where the wall would get too thin, on the polygon circumscribed
/// about the circle. Corners that face the axis are on the circumscribed polygon, so that the
/// middle of each facet touches the true circle.
std::vector<ConvexPiece> MakeLathePieces(const Lathe& lathe, const Outline& outline,
                                         const ConvexPartition& partition);

}  // namespace mjforge::solid
