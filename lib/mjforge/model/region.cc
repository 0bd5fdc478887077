// Geometry of regions: positions of discs inside a region, and distances of points outside.

#include "mjforge/model/region.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mjforge/solid/solid.h"

namespace mjforge::model {

std::string_view RegionTypeName(RegionType type) {
  constexpr std::array<std::string_view, 3> kNames = {"box", "disc", "polygon"};
  return kNames[static_cast<std::size_t>(type)];
}

double TiltOf(const Pose& X_WR) {
  const Eigen::Vector3d up = X_WR.q * Eigen::Vector3d::UnitZ();
  return std::atan2(up.head<2>().norm(), up.z());
}

Eigen::Vector2d MiddleOf(const Region& region) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  if (region.type != RegionType::kPolygon) return sum;
  for (const Eigen::Vector2d& corner : region.corners) sum += corner;
  return sum / static_cast<double>(region.corners.size());
}

Eigen::Vector2d PositionOfDisc(const Region& region, double radius, const Eigen::Vector2d& uv) {
  if (region.type != RegionType::kPolygon) {
    const Eigen::Vector2d play = (region.half_size.array() - region.margin - radius).cwiseMax(0);
    return uv.cwiseProduct(play);
  }
  // The largest disc about the mean of the corners has the radius `play`.
  const Eigen::Vector2d middle = MiddleOf(region);
  const double play = -DistanceOutside(region, middle);
  return middle + uv / std::max(1.0, uv.norm()) * std::max(0.0, play - region.margin - radius);
}

double DistanceOutside(const Region& region, const Eigen::Vector2d& p) {
  if (region.type == RegionType::kBox) return (p.cwiseAbs() - region.half_size).maxCoeff();
  if (region.type == RegionType::kDisc) return p.norm() - region.half_size.x();
  double outside = -region.half_size.norm();
  for (std::size_t i = 0; i < region.corners.size(); ++i)
    outside = std::max(outside, solid::OutwardNormal(region.corners, i).dot(p - region.corners[i]));
  return outside;
}

}  // namespace mjforge::model
