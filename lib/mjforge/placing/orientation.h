// A body in the orientation in which it is placed.

#pragma once

#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/placing/body_shapes.h"
#include "mjforge/placing/footprint.h"

namespace mjforge::placing {

/// A body in one orientation, except for a rotation about the vertical. Frame L has the origin of
/// the body, and the z axis of L points up.
struct Orientation {
  std::optional<Eigen::Quaterniond> asked;  // nullopt: as modelled, if stable
  Eigen::Quaterniond q_LB;
  std::vector<BodyShape> shapes;                   // in the body's frame B
  PlacedShapes placed;                             // these shapes in frame L
  Footprint footprint;                             // in frame L
  Eigen::Vector3d p_BCm;                           // centre of mass in frame B
  double bottom = 0;                               // least z in L, m
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  // sides of the bounding box in L, m
};

/// Returns the orientation `asked` of a body with all bodies below it. If `asked` is nullopt,
/// returns the modelled orientation or, if the body would tip over, the stable pose with the
/// smallest rotation from the modelled orientation.
Orientation OrientationOf(const model::Object& object, int body,
                          const std::optional<Eigen::Quaterniond>& asked);

}  // namespace mjforge::placing
