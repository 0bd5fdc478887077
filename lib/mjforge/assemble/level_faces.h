// Search for level upper faces of solids: the shape of each face, and the free height above it.

#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// A colliding part, and its pose in a frame W whose z axis points up.
struct PlacedShape {
  model::Shape shape;
  model::Pose X_WG;
  model::Box3 box;                 // bounds of the shape in W
  std::string_view piece_of = {};  // part of which the shape is a convex piece; may be empty
};

/// A level upper face of one shape, or of several adjacent convex pieces of one part.
struct LevelFace {
  /// Corners of a convex polygon in W, counter-clockwise from above. For a disc, a polygon around
  /// the disc.
  std::vector<Eigen::Vector2d> corners;
  double z = 0;                  // height of the face in W, m
  std::optional<double> radius;  // radius of a disc, m; nullopt for a polygon
  double height = std::numeric_limits<double>::infinity();  // free height above the face, m
};

/// Returns the area of a face, m^2.
double AreaOfFace(const LevelFace& face);

/// Returns the level upper faces of the shapes `own` that have at least the area `area`, m^2, and
/// at least the free height `height`, m, below the shapes `all`; the largest face comes first. A
/// partly covered face is cut parallel to its edges until the rest is free. Considers only the 64
/// largest faces before such cuts.
std::vector<LevelFace> FindLevelFaces(std::span<const PlacedShape> own,
                                      std::span<const PlacedShape> all, double area, double height);

}  // namespace mjforge::assemble
