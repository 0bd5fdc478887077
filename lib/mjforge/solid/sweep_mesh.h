// Render mesh, convex pieces and extent of a tube.

#pragma once

#include <vector>

#include "mjforge/solid/sweep_path.h"

namespace mjforge::solid {

TriangleMesh MakeSweepMesh(const std::vector<PathSegment>& segments, const Tube& tube);

/// Makes the convex pieces of a tube: capsules, cylinders at the ends of an open path, and cones
/// where the radius changes.
std::vector<ConvexPiece> MakeSweepPieces(const std::vector<PathSegment>& segments,
                                         const Tube& tube);

/// Returns the extent of a tube: discs and ellipses at the ends of all segments, and outer arcs of
/// bends. A cubic segment is replaced by 16 arcs through its points, with an error below 0.1 mm in
/// a tube of 10 cm.
Extent SweepExtentOf(const std::vector<PathSegment>& segments, bool closed);

}  // namespace mjforge::solid
