// Regions: named level areas of a body, on which other bodies can stand.

#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/diag/diag.h"
#include "mjforge/model/poses.h"

namespace mjforge::model {

/// Group (MJCF attribute) of the sites that represent regions. Viewers hide this group by default.
inline constexpr int kRegionGroup = 5;

enum class RegionType { kBox, kDisc, kPolygon };

/// Returns the name of a type in specs: "box", "disc" or "polygon".
std::string_view RegionTypeName(RegionType type);

/// A level area of a body B, or the floor of a container, and the space above. The area is in the
/// xy plane of the region's frame R. The z axis of R points up in the start state of the object.
struct Region {
  std::string name;  // name in the spec: "surface"
  std::string site;  // full name of the region's site in MJCF
  RegionType type = RegionType::kBox;
  /// Half lengths along x and y, m, of a box or of a polygon's bounding box. For a disc, both
  /// numbers are the radius.
  Eigen::Vector2d half_size = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> corners;  // corners of a convex polygon in R, counter-clockwise, m
  Pose X_BR;
  double height = std::numeric_limits<double>::infinity();  // free height above the area, m
  double margin = 0;  // least distance of footprints from the edge, m
  double clear = 0;   // least distance between bodies in the region, m
  // True for the interior of a container, into which bodies are lowered; the floor may be uneven.
  bool has_walls = false;
  diag::SourceMark mark;
};

/// Returns the angle between the z axis of R and the vertical, rad.
double TiltOf(const Pose& X_WR);

/// Returns the mean of a polygon's corners, in the plane of R. For other regions, returns the
/// origin.
Eigen::Vector2d MiddleOf(const Region& region);

/// Returns the centre, in the plane of R, of a disc with this radius that is inside the region and
/// at least Region::margin away from the region's edge. `uv` selects the centre. For a box, its
/// numbers from -1 to 1 span all such centres. Otherwise, `uv` is a point of the unit disc, which
/// spans all such centres of a disc, and a part of those of a polygon: the largest disc about its
/// middle. If the disc is too large for the region, returns the middle of the region.
Eigen::Vector2d PositionOfDisc(const Region& region, double radius, const Eigen::Vector2d& uv);

/// Returns the largest distance, m, by which a point in the plane of R is beyond the line of any
/// edge of the region, or beyond the circle of a disc; 0 or negative if the point is inside.
double DistanceOutside(const Region& region, const Eigen::Vector2d& p);

}  // namespace mjforge::model
