// Prisms with holes along more than one axis.

#pragma once

#include <array>
#include <optional>

#include "mjforge/solid/inset_polygon.h"

namespace mjforge::solid {

/// Cross sections of the three intersected extrusions of which the solid consists, by the axis
/// along which each is extruded. The sections along x and y are rectangles around the prism, with
/// its holes.
using CutSections = std::array<Area, 3>;

/// Makes a prism with holes along x or y. Its pieces fill it exactly. `base` has its polygon and
/// the holes along z. Returns nothing and sets `fault` if the prism is rounded or bevelled, if a
/// hole is faulty, or if the holes leave several parts that do not touch.
std::optional<Solid> MakeCutPrism(const Prism& prism, const BasePolygon& base, Fault& fault);

/// Makes the render mesh.
TriangleMesh MakeCutMesh(const Prism& prism, const CutSections& sections);

}  // namespace mjforge::solid
