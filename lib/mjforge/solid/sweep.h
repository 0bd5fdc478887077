#pragma once

#include <vector>

#include "mjforge/solid/center_line.h"

namespace mjforge::solid {

/// A place on a line, with directions across it.
struct Station {
  Eigen::Vector3d p;
  Eigen::Vector3d way;  // of length 1
  Eigen::Vector3d x;    // across, of length 1
  Eigen::Vector3d cut;  // normal of the plane that ends the line there: `way`, but at corners
  double radius = 0;
  double slope = 0;  // of the radius along the line
  double along = 0;  // m
  Eigen::Vector3d y() const { return way.cross(x); }
};

/// Stations at both ends of each span, and between them `per_turn` to a turn of an arc, as many to
/// a curve of four spans. Those across do not turn about the line more than they must; at the end
/// of a closed line they are what they were at its beginning. Source: Wang, Juettler, Zheng and
/// Liu, "Computation of rotation minimizing frames", 2008.
std::vector<Station> StationsOf(const std::vector<Span>& spans, bool closed, int per_turn);

Surface SweptLook(const std::vector<Span>& spans, const Tube& tube);

/// Capsules, with cylinders at the ends of an open line; where the radius changes, cones.
std::vector<Piece> SweptPieces(const std::vector<Span>& spans, const Tube& tube);

}  // namespace mjforge::solid
