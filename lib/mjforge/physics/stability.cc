// Computes static stability from the height of the centre of mass over the floor at each tilt, by
// support functions of the geoms.
#include "mjforge/physics/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "mjforge/compiled/compiled.h"

namespace mjforge::physics {
namespace {

constexpr int kDirections = 72;                         // number of directions of the tilt
constexpr double kStep = 0.5 * std::numbers::pi / 180;  // rad, from one tilt to the next
// Tolerance for rounding errors of heights, as a share of the height of the centre of mass, because
// the centre of a rolling ball does not rise.
constexpr double kFlat = 1e-9;
constexpr double kUneven = 10 * std::numbers::pi / 180;  // rad, largest tilt due to uneven sinking

/// Convex hull of the colliding geoms of a tree of bodies, relative to its centre of mass.
class ObjectHull {
 public:
  ObjectHull(const mjModel& m, const mjData& d, int root) {
    const Eigen::Vector3d center = compiled::VectorAt(d.subtree_com, root);
    for (int geom = 0; geom < m.ngeom; ++geom) {
      if (m.body_rootid[m.geom_bodyid[geom]] != root || !compiled::Collides(m, geom)) continue;
      const std::optional<model::GeomType> type = compiled::GeomTypeOf(m.geom_type[geom]);
      if (!type) continue;
      model::Pose pose = compiled::GeomPose(d, geom);
      pose.p = pose.p - center;
      if (*type == model::GeomType::kMesh) {
        const int mesh = m.geom_dataid[geom];
        const float* vertices = m.mesh_vert + 3 * m.mesh_vertadr[mesh];
        for (int i = 0; i < m.mesh_vertnum[mesh]; ++i) {
          const Eigen::Vector3d p =
              Eigen::Map<const Eigen::Vector3f>(vertices + 3 * i).cast<double>();
          points_.emplace_back(pose.p + pose.q * p);
        }
      } else {
        model::Shape shape{.type = *type};
        shape.size = compiled::VectorAt(m.geom_size, geom);
        shapes_.emplace_back(shape, pose);
      }
    }
  }

  /// Returns the height of the centre of mass above the floor, m, when the object is tilted so that
  /// its direction `down` points down.
  double Below(const Eigen::Vector3d& down) const {
    double lowest = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& p : points_) lowest = std::max(lowest, p.dot(down));
    for (const auto& [shape, pose] : shapes_) {
      const double own = model::Support(shape, pose.q.conjugate() * down);
      lowest = std::max(lowest, pose.p.dot(down) + own);
    }
    return lowest;
  }

 private:
  std::vector<Eigen::Vector3d> points_;
  std::vector<std::pair<model::Shape, model::Pose>> shapes_;
};

}  // namespace

StabilityMargin FindStabilityMargin(const mjModel& m, const mjData& d, int root, double sink) {
  const ObjectHull hull(m, d, root);
  const double height = hull.Below(-Eigen::Vector3d::UnitZ());
  const double weight =
      m.body_subtreemass[root] * Eigen::Map<const Eigen::Vector3d>(m.opt.gravity).norm();
  StabilityMargin margin;
  margin.least = {.angle = std::numbers::pi, .energy = std::numeric_limits<double>::infinity()};
  for (int way = 0; way < kDirections; ++way) {
    const double azimuth = 2 * std::numbers::pi * way / kDirections;
    double highest = height;
    double angle = 0;
    for (double tilt = kStep; tilt < std::numbers::pi; tilt += kStep) {
      const double side = std::sin(tilt);
      const double now =
          hull.Below({side * std::cos(azimuth), side * std::sin(azimuth), -std::cos(tilt)});
      if (now > highest + kFlat * height) {
        highest = now;
        angle = tilt;
      } else if (tilt > kUneven || highest > height + sink || now < height - sink) {
        break;
      }
    }
    if (angle < margin.least.angle) margin.azimuth = azimuth;
    margin.least.angle = std::min(margin.least.angle, angle);
    margin.least.energy = std::min(margin.least.energy, weight * (highest - height));
  }
  return margin;
}

}  // namespace mjforge::physics
