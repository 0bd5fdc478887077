#include "mjforge/picture/support.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mjforge/compiled/compiled.h"

namespace mjforge::picture {

double Shape::Support(const Eigen::Vector3d& direction) const {
  const Eigen::Vector3d d = R_WS.transpose() * direction;
  const double center = direction.dot(p_WS);
  if (vertices.empty()) return center + model::Support(solid, d);
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < vertices.size(); i += 3) {
    most = std::max(most, d.x() * vertices[i] + d.y() * vertices[i + 1] + d.z() * vertices[i + 2]);
  }
  return center + most;
}

Shape ShapeOf(const mjModel& m, const mjvGeom& geom) {
  Shape shape;
  shape.p_WS = Eigen::Map<const Eigen::Vector3f>(geom.pos).cast<double>();
  shape.R_WS =
      Eigen::Map<const Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(geom.mat).cast<double>();
  Eigen::Vector3d& size = shape.solid.size;
  size = Eigen::Map<const Eigen::Vector3f>(geom.size).cast<double>();
  if (geom.type == mjGEOM_MESH && geom.objtype == mjOBJ_GEOM) {
    const int mesh = m.geom_dataid[geom.objid];
    shape.vertices = {m.mesh_vert + 3 * m.mesh_vertadr[mesh],
                      3 * static_cast<std::size_t>(m.mesh_vertnum[mesh])};
  } else if (geom.type == mjGEOM_HFIELD && geom.objtype == mjOBJ_GEOM) {
    const mjtNum* sides = m.hfield_size + 4 * m.geom_dataid[geom.objid];
    size = {sides[0], sides[1], sides[2]};
  } else if (geom.type == mjGEOM_PLANE) {
    size.z() = 0;
  } else if (const auto type = compiled::GeomTypeOf(geom.type);
             type && *type != model::GeomType::kMesh) {
    shape.solid.type = *type;
    // mjvGeom has radii of x and y, and the half length last.
    if (model::SizeCount(*type) == 2) size = {size.x(), size.z(), 0};
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
