// Conversion of geoms in a scene (mjvGeom) to shapes, and support functions of shapes and shadows.

#include "mjforge/picture/support.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mjforge/compiled/compiled.h"

namespace mjforge::picture {

double PlacedShape::Support(const Eigen::Vector3d& direction) const {
  const Eigen::Vector3d d = R_WS.transpose() * direction;
  const double center = direction.dot(p_WS);
  if (vertices.empty()) return center + model::Support(solid, d);
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < vertices.size(); i += 3) {
    most = std::max(most, d.x() * vertices[i] + d.y() * vertices[i + 1] + d.z() * vertices[i + 2]);
  }
  return center + most;
}

PlacedShape ShapeOf(const mjModel& m, const mjvGeom& geom) {
  PlacedShape shape;
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
    // The size of a capsule or cylinder in an mjvGeom is: radius along x, along y, half length.
    if (model::SizeCount(*type) == 2) size = {size.x(), size.z(), 0};
  }
  return shape;
}

void PlacedShapes::Add(const PlacedShapes& other) {
  shapes_.insert(shapes_.end(), other.shapes_.begin(), other.shapes_.end());
}

double PlacedShapes::Support(const Eigen::Vector3d& direction) const {
  double most = -std::numeric_limits<double>::infinity();
  for (const PlacedShape& shape : shapes_) most = std::max(most, shape.Support(direction));
  return most;
}

// Computes the support function of the shadow from that of the shapes. The shadow of a point is
// displaced from the point by its height above the plane times the slope of the light.
double PlacedShapes::ShadowSupport(const Eigen::Vector3d& direction, const Eigen::Vector3d& light,
                                   double level) const {
  const double slope = direction.dot(light) / -light.z();
  return Support(direction + slope * Eigen::Vector3d::UnitZ()) - slope * level;
}

Eigen::Vector3d PlacedShapes::Min() const {
  return {-Support(-Eigen::Vector3d::UnitX()), -Support(-Eigen::Vector3d::UnitY()),
          -Support(-Eigen::Vector3d::UnitZ())};
}

Eigen::Vector3d PlacedShapes::Max() const {
  return {Support(Eigen::Vector3d::UnitX()), Support(Eigen::Vector3d::UnitY()),
          Support(Eigen::Vector3d::UnitZ())};
}

// The largest distance of a convex set from an axis is the maximum of its support function over all
// horizontal directions. With 720 directions the relative error is at most 1 - cos(0.25 deg).
double PlacedShapes::HorizontalRadius(const Eigen::Vector3d& axis) const {
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
