// Geometry of regions: positions of discs inside, and distances of points outside.

#include "mjforge/model/region.h"

#include <algorithm>
#include <cmath>

namespace mjforge::model {

Eigen::Vector2d PositionOfDisc(const Region& region, double radius, const Eigen::Vector2d& uv) {
  if (region.type != RegionType::kPolygon) {
    const Eigen::Vector2d play = (region.half_size.array() - region.margin - radius).cwiseMax(0);
    return uv.cwiseProduct(play);
  }
  // The largest disc about the middle of the corners.
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : region.corners)
    middle += corner / static_cast<double>(region.corners.size());
  double play = region.half_size.norm();
  for (std::size_t i = 0; i < region.corners.size(); ++i) {
    const Eigen::Vector2d from = region.corners[i];
    const Eigen::Vector2d along =
        (region.corners[(i + 1) % region.corners.size()] - from).normalized();
    play =
        std::min(play, std::abs(along.x() * (middle - from).y() - along.y() * (middle - from).x()));
  }
  return middle + uv / std::max(1.0, uv.norm()) * std::max(0.0, play - region.margin - radius);
}

double DistanceOutside(const Region& region, const Eigen::Vector2d& p) {
  if (region.type == RegionType::kBox) return (p.cwiseAbs() - region.half_size).maxCoeff();
  if (region.type == RegionType::kDisc) return p.norm() - region.half_size.x();
  double outside = -region.half_size.norm();
  for (std::size_t i = 0; i < region.corners.size(); ++i) {
    const Eigen::Vector2d from = region.corners[i];
    const Eigen::Vector2d along =
        (region.corners[(i + 1) % region.corners.size()] - from).normalized();
    outside = std::max(outside, along.y() * (p - from).x() - along.x() * (p - from).y());
  }
  return outside;
}

}  // namespace mjforge::model
