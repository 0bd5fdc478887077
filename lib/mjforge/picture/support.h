// Shapes of the geoms in a scene (mjvGeom), and their support functions, by which the camera frames
// them.

#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <span>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::picture {

/// A convex shape at a pose in the world. S is the shape's own frame; lengths are in m.
struct PlacedShape {
  /// Shape of the geom; a box for planes, height fields and other types that model::Shape lacks.
  model::Shape solid = {.type = model::GeomType::kBox};
  Eigen::Vector3d p_WS = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R_WS = Eigen::Matrix3d::Identity();
  /// Vertices of a mesh in S, 3 numbers each; used instead of `solid` unless empty.
  std::span<const float> vertices = {};

  /// Returns the largest dot product of `direction` with a point of the shape.
  double Support(const Eigen::Vector3d& direction) const;
};

PlacedShape ShapeOf(const mjModel& m, const mjvGeom& geom);

class PlacedShapes {
 public:
  void Add(const PlacedShape& shape) { shapes_.push_back(shape); }
  void Add(const PlacedShapes& other);
  bool empty() const { return shapes_.empty(); }

  double Support(const Eigen::Vector3d& direction) const;
  /// Returns the support function of the shadow that the shapes cast on the plane z = `level`, m.
  /// `light` is the direction of the light, downwards.
  double ShadowSupport(const Eigen::Vector3d& direction, const Eigen::Vector3d& light,
                       double level) const;
  Eigen::Vector3d Min() const;
  Eigen::Vector3d Max() const;
  /// Returns the largest horizontal distance of the shapes from the vertical line through the point
  /// `axis`, m, with a relative error of 1e-5.
  double HorizontalRadius(const Eigen::Vector3d& axis) const;

 private:
  std::vector<PlacedShape> shapes_;
};

}  // namespace mjforge::picture
