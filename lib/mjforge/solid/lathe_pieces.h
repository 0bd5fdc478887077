// Convex pieces of a lathe.

#pragma once

#include <vector>

#include "mjforge/solid/convex_partition.h"

namespace mjforge::solid {

/// Makes the convex pieces of a revolved outline. A convex polygon with a side on the axis, none of
/// whose other sides faces the axis, becomes one piece; any other polygon becomes a wedge, repeated
/// for each facet. Corners that face away from the axis are on the true circle or, where the wall
/// would get too thin, on the polygon circumscribed about it; corners that face the axis are on the
/// circumscribed polygon, so that the middle of each facet touches the true circle.
std::vector<ConvexPiece> MakeLathePieces(const Lathe& lathe, const Outline& outline,
                                         const ConvexPartition& partition);

}  // namespace mjforge::solid
