// Base polygon of a prism, with rounded corners and holes, and its insets for bevels.

#pragma once

#include <optional>
#include <vector>

#include "mjforge/solid/moments.h"

namespace mjforge::solid {

/// Cross sections in the middle and at both ends of a prism, with equal numbers of corners.
struct PrismSections {
  Area middle;
  Area end;
};

/// The cross section of a prism before it is bevelled: outline and holes.
struct BasePolygon {
  /// The outline counter-clockwise, before its corners are rounded, then the holes clockwise.
  std::vector<Outline> loops;
  double round = 0;  // radius of the outline's corners, m

  /// Returns the unit vectors of the arcs of each loop, which do not depend on the inset.
  std::vector<std::vector<ArcDirections>> Directions() const;
  /// Returns quadrature nodes on the boundary after all sides are moved inwards by `inset`, m.
  /// `directions` is the result of Directions().
  std::vector<QuadratureNode> BoundaryAt(
      double inset, const std::vector<std::vector<ArcDirections>>& directions) const;
  /// Returns the cross sections of a prism whose bevel has this width, m. `per_turn` and `inside`
  /// are arguments of PointsOf().
  PrismSections SectionsAt(double bevel, int per_turn, bool inside) const;
  /// Returns the corners of a loop after all sides are moved inwards by `inset`, m.
  std::vector<RoundedCorner> CornersOf(std::size_t loop, double inset) const;
};

/// Makes the base polygon of a prism. Returns nullopt and sets `fault` if outline, holes, rounding
/// and bevel do not make a prism.
std::optional<BasePolygon> BasePolygonOf(const Prism& prism, Fault& fault);

}  // namespace mjforge::solid
