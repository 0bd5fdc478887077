#pragma once

// How far drawn shapes reach.

#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <span>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::picture {

/// A convex shape S in the world, m.
struct Shape {
  model::Shape solid = {.type = model::GeomType::kBox};  // a box for all that has no formula
  Eigen::Vector3d p_WS = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R_WS = Eigen::Matrix3d::Identity();
  std::span<const float> vertices = {};  // of a mesh, in place of the solid: 3 each, in S

  /// The largest dot product of `direction` with a point of it.
  double Support(const Eigen::Vector3d& direction) const;
};

Shape ShapeOf(const mjModel& m, const mjvGeom& geom);

class Shapes {
 public:
  void Add(const Shape& shape) { shapes_.push_back(shape); }
  void Add(const Shapes& other);
  bool empty() const { return shapes_.empty(); }

  double Support(const Eigen::Vector3d& direction) const;
  Eigen::Vector3d Min() const;
  Eigen::Vector3d Max() const;
  /// The largest distance from the vertical through a point, with a relative error of 1e-5.
  double HorizontalRadius(const Eigen::Vector3d& axis) const;

 private:
  std::vector<Shape> shapes_;
};

}  // namespace mjforge::picture
