// Parts of a render mesh that all prisms share: caps, strips of the sides, and texture coordinates.

#pragma once

#include <vector>

#include "mjforge/solid/inset_polygon.h"

namespace mjforge::solid {

/// Rectangle that one side of an outline sweeps when the outline is extruded along its axis.
struct Strip {
  Point2 from = Point2::Zero();
  Point2 to = Point2::Zero();
  Point2 outward = Point2::Zero();
  Point2 normal_from = Point2::Zero();  // blended with the neighbour's normal if the edge is smooth
  Point2 normal_to = Point2::Zero();
  bool is_smooth = false;  // true: the edge at `from` is smooth
  double along = 0;        // length of the outline up to `from`
};

/// Returns the strips of the sides of a loop of `area`. Edges whose sides differ in direction by at
/// most `crease`, rad, are smooth.
std::vector<Strip> StripsOf(const Area& area, std::size_t loop, double crease);

/// Render mesh of a prism under construction.
class PrismMesh {
 public:
  /// `section` is the cross section in the middle of the prism.
  PrismMesh(const Prism& prism, const Area& section);

  int AddVertex(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, const Point2& texcoord);
  /// Adds a vertex of a side. `unrolled` is its place along the outline and down from the top, m.
  int AddSideVertex(const Eigen::Vector3d& p, const Eigen::Vector3d& normal,
                    const Point2& unrolled) {
    return AddVertex(p, normal, unrolled.cwiseProduct(side_scale_));
  }
  /// Adds both ends of the prism. `area` is the cross section there.
  void AddCaps(const Area& area);

  TriangleMesh mesh;

 private:
  const Prism& prism_;
  Eigen::AlignedBox2d picture_;  // bounds of the caps in the coordinates of OnPicture()
  Point2 cap_scale_;
  Point2 side_scale_;
};

}  // namespace mjforge::solid
