// Parts of a render mesh that all prisms share: caps, and texture coordinates of caps and sides.

#pragma once

#include "mjforge/solid/inset_polygon.h"

namespace mjforge::solid {

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
