// Rounding of an outline's corners by circular arcs.

#pragma once

#include <optional>
#include <vector>

#include "mjforge/solid/outline.h"

namespace mjforge::solid {

/// A corner of an outline, or the arc that replaces it.
struct RoundedCorner {
  Point2 place;       // sharp corner, or centre of the arc
  double radius = 0;  // m; 0 for a sharp corner
  double from = 0;    // direction from the centre to the start of the arc, rad from the x axis
  double sweep = 0;   // angle of the arc, rad, positive to the left
};

/// Rounds each corner of an outline with its radius, m (0 leaves the corner sharp), and moves all
/// sides by `inset`, m, to their left: the radii of arcs that turn left shrink by `inset`, others
/// grow. `radii` has one number per corner. Returns nullopt and sets `fault` if a side is too
/// short.
std::optional<std::vector<RoundedCorner>> RoundCorners(const Outline& outline,
                                                       const std::vector<double>& radii,
                                                       double inset, Fault& fault);

/// Returns the corners, with points along each arc at `per_turn` steps in a whole turn. The points
/// are on the arcs. With `inside`, the points of arcs that turn right are on the circumscribed
/// polygon, so that the area to the left of the outline does not grow.
std::vector<Point2> PointsOf(const std::vector<RoundedCorner>& corners, int per_turn, bool inside);

}  // namespace mjforge::solid
