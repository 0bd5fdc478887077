// Prisms with holes along x or y, as intersections of extrusions along the three axes.

#pragma once

#include <array>
#include <optional>

#include "mjforge/solid/inset_polygon.h"

namespace mjforge::solid {

/// Cross sections of three extrusions along x, y and z; the solid is the intersection of the
/// extrusions. Section i is in the coordinates of kSectionPlanes[i]. The sections along x and y are
/// rectangles around the prism, each with the holes along its axis.
using CutSections = std::array<Area, 3>;

/// Returns the bounding box, m, of a prism without rounding, bevels and holes.
Eigen::AlignedBox3d BoundsOf(const Prism& prism);

/// Makes a prism with holes along x or y. The pieces fill the prism exactly. `base` has the polygon
/// and the holes along z. Returns nullopt and sets `fault` if the prism is rounded or bevelled, if
/// a hole is faulty, if there are more than 1000 pieces, or if the holes leave several parts that
/// do not touch.
std::optional<Solid> MakeCutPrism(const Prism& prism, const BasePolygon& base, Fault& fault);

/// Makes the render mesh of a prism with holes: the intersection of the three extrusions whose
/// cross sections are `sections`.
TriangleMesh MakeCutMesh(const Prism& prism, const CutSections& sections);

}  // namespace mjforge::solid
