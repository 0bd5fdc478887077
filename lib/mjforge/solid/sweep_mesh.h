// Render mesh and convex pieces of a tube.

#pragma once

#include <vector>

#include "mjforge/solid/sweep_path.h"

namespace mjforge::solid {

TriangleMesh MakeSweepMesh(const std::vector<PathSegment>& segments, const Tube& tube);

/// Makes capsules, cylinders at the ends of an open path, and cones where the radius changes.
std::vector<ConvexPiece> MakeSweepPieces(const std::vector<PathSegment>& segments,
                                         const Tube& tube);

}  // namespace mjforge::solid
