// Regions: named level places on a body where other bodies can stand.

#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/diag/diag.h"
#include "mjforge/model/poses.h"

namespace mjforge::model {

/// Group of the sites of regions, which viewers hide.
inline constexpr int kRegionGroup = 5;

enum class RegionType { kBox, kDisc, kPolygon };

/// Returns the word of a spec: "box", "disc" or "polygon".
std::string_view RegionTypeName(RegionType type);

/// A level area of a body B, or the interior of a container, with the space above it. The area is
/// in the xy plane of its frame R, whose z axis points up when the object is in its start state.
struct Region {
  std::string name;  // name in the spec: "surface"
  std::string site;  // full name of its site in MJCF
  RegionType type = RegionType::kBox;
  /// Half lengths along x and y, m; for a disc, its radius twice. For a polygon, of its bounding
  /// box.
  Eigen::Vector2d half_size = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> corners;  // corners of a convex polygon, counter-clockwise, m
  Pose X_BR;
  double height = std::numeric_limits<double>::infinity();  // free height above the area, m
  double margin = 0;   // least distance of footprints from the edge, m
  double clear = 0;    // least distance that the owner asks for between what stands here, m
  bool walls = false;  // an interior, whose floor need not be level: objects are lowered into it
  diag::SourceMark mark;
};

/// Returns the angle between the z axis of R and the vertical, rad.
double TiltOf(const Pose& X_WR);

/// Returns the mean of a polygon's corners, in the plane of R; for other regions the origin.
Eigen::Vector2d MiddleOf(const Region& region);

/// Returns the position, in the plane of R, of a disc of this radius: `uv`, from -1 to 1, within
/// the positions at which the disc is inside; in a disc, and in the largest disc of a polygon,
/// within the unit disc. If the disc is too large, the middle of the region.
Eigen::Vector2d PositionOfDisc(const Region& region, double radius, const Eigen::Vector2d& uv);

/// Returns how far a point in the plane of R is outside of the region, m; at most 0 inside.
double DistanceOutside(const Region& region, const Eigen::Vector2d& p);

}  // namespace mjforge::model
