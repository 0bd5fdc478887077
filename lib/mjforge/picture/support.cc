#include "mjforge/picture/support.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mjforge::picture {

double Shape::Support(const Eigen::Vector3d& direction) const {
  const Eigen::Vector3d d = R_WS.transpose() * direction;
  const double center = direction.dot(p_WS);
  if (vertices != nullptr) {
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < vertex_count; ++i) {
      const float* v = vertices + 3 * i;
      most = std::max(most, d.x() * v[0] + d.y() * v[1] + d.z() * v[2]);
    }
    return center + most;
  }
  switch (type) {
    case mjGEOM_SPHERE:
    case mjGEOM_ELLIPSOID:
      return center + d.cwiseProduct(size).norm();
    case mjGEOM_CAPSULE:
      return center + size.x() * d.norm() + size.z() * std::abs(d.z());
    case mjGEOM_CYLINDER:
      return center + size.x() * std::hypot(d.x(), d.y()) + size.z() * std::abs(d.z());
    default:
      return center + size.dot(d.cwiseAbs());
  }
}

Shape ShapeOf(const mjModel& m, const mjvGeom& geom) {
  Shape shape;
  shape.type = geom.type;
  shape.size = Eigen::Map<const Eigen::Vector3f>(geom.size).cast<double>();
  shape.p_WS = Eigen::Map<const Eigen::Vector3f>(geom.pos).cast<double>();
  shape.R_WS =
      Eigen::Map<const Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(geom.mat).cast<double>();
  if (geom.type == mjGEOM_MESH && geom.objtype == mjOBJ_GEOM) {
    const int mesh = m.geom_dataid[geom.objid];
    shape.vertices = m.mesh_vert + 3 * m.mesh_vertadr[mesh];
    shape.vertex_count = m.mesh_vertnum[mesh];
  } else if (geom.type == mjGEOM_HFIELD && geom.objtype == mjOBJ_GEOM) {
    const mjtNum* size = m.hfield_size + 4 * m.geom_dataid[geom.objid];
    shape.size = {size[0], size[1], size[2]};
  } else if (geom.type == mjGEOM_PLANE) {
    shape.size.z() = 0;
  }
  return shape;
}

void Shapes::Add(const Shapes& other) {
  shapes_.insert(shapes_.end(), other.shapes_.begin(), other.shapes_.end());
}

double Shapes::Support(const Eigen::Vector3d& direction) const {
  double most = -std::numeric_limits<double>::infinity();
  for (const Shape& shape : shapes_) most = std::max(most, shape.Support(direction));
  return most;
}

Eigen::Vector3d Shapes::Min() const {
  return {-Support(-Eigen::Vector3d::UnitX()), -Support(-Eigen::Vector3d::UnitY()),
          -Support(-Eigen::Vector3d::UnitZ())};
}

Eigen::Vector3d Shapes::Max() const {
  return {Support(Eigen::Vector3d::UnitX()), Support(Eigen::Vector3d::UnitY()),
          Support(Eigen::Vector3d::UnitZ())};
}

// The farthest point of a convex set from an axis is the farthest in the direction
// it lies in; 720 directions miss it by at most 1 - cos(0.25 deg).
double Shapes::HorizontalRadius(const Eigen::Vector3d& axis) const {
  constexpr int kDirections = 720;
  double radius = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDirections;
    const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0);
    radius = std::max(radius, Support(direction) - direction.dot(axis));
  }
  return radius;
}

}  // namespace mjforge::picture
