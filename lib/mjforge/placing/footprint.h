// Footprint of an object: the convex hull, seen from above, of its points near the lowest point.

#pragma once

#include <span>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/distance/distance.h"

namespace mjforge::placing {

/// A disc in a level plane, m; a point if the radius is 0.
struct Disc {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0;
};

using Polygon = std::vector<Eigen::Vector2d>;  // convex, counter-clockwise

/// The convex hull of at least one disc.
class Footprint {
 public:
  explicit Footprint(std::vector<Disc> discs);

  const std::vector<Disc>& discs() const { return discs_; }
  /// Returns the footprint turned about the origin by an angle, rad.
  Footprint Turned(double angle) const;
  /// Support function: returns the largest dot(direction, point) over all points.
  double Support(const Eigen::Vector2d& direction) const;
  const Eigen::AlignedBox2d& Box() const { return box_; }
  /// Returns the convex hull of 64 points on the border of each disc. The polygon is inside the
  /// footprint, because arcs become chords.
  Polygon Outline() const;

 private:
  std::vector<Disc> discs_;
  Eigen::AlignedBox2d box_;
};

constexpr double kFootprintHeight = 1e-3;  // default height of FootprintOf(), m

/// Returns the footprint of shapes in a frame whose z axis points up: the points at most `height`,
/// m, above the lowest point. Boxes, meshes, spheres, upright cylinders and level capsules are
/// exact; other curved shapes have points of their outline, less than 0.1 mm inside of it for
/// objects of everyday size. Without shapes, the footprint is the origin.
Footprint FootprintOf(std::span<const distance::PlacedShape> shapes,
                      double height = kFootprintHeight);

}  // namespace mjforge::placing
