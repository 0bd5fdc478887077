// Orientation in which a body is placed, and a test whether the body would tip over.

#include "mjforge/placing/orientation.h"

#include <algorithm>

#include "mjforge/placing/stable_poses.h"
#include "mjforge/placing/tilting.h"
#include "mjforge/solid/solid.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector3d;
using model::Pose;

Orientation Oriented(const model::Object& object, int body, const Eigen::Quaterniond& q_LB) {
  std::vector<BodyShape> shapes = ShapesBelow(object, body);
  PlacedShapes placed = ShapesAt(shapes, {Vector3d::Zero(), q_LB});
  Footprint footprint = FootprintOf(placed);
  Orientation orientation{q_LB,
                          q_LB,
                          std::move(shapes),
                          std::move(placed),
                          std::move(footprint),
                          MassBelow(object, body).p_FCm};
  if (orientation.placed.empty()) return orientation;
  const Eigen::AlignedBox3d box = distance::BoxAround(orientation.placed);
  orientation.bottom = box.min().z();
  orientation.size = box.sizes();
  return orientation;
}

// Returns true if, in the modelled orientation, the centre of mass of the body is above the convex
// hull of its points that touch the ground, and does not sink when the body is tilted a little: on
// a rounded end, or on an apex, it would sink.
bool IsStable(const Orientation& upright) {
  constexpr double kTouching = 1e-4;  // m; higher points do not touch the ground
  constexpr double kTilt = 0.02;      // rad
  if (!solid::ConvexContains(FootprintOf(upright.placed, kTouching).Outline(),
                             upright.p_BCm.head<2>()))
    return false;
  return !SinksWhenTilted(upright.placed, upright.q_LB * upright.p_BCm, -Vector3d::UnitZ(), kTilt);
}

}  // namespace

Orientation OrientationOf(const model::Object& object, int body,
                          const std::optional<Eigen::Quaterniond>& asked) {
  Orientation orientation = Oriented(object, body, asked.value_or(Eigen::Quaterniond::Identity()));
  if (!asked && !IsStable(orientation)) {
    const std::vector<model::StablePose> poses = StablePosesOf(object, body, 0);
    const auto least = std::ranges::max_element(
        poses, {}, [](const model::StablePose& pose) { return pose.rotation.w(); });
    if (least != poses.end()) orientation = Oriented(object, body, least->rotation);
  }
  orientation.asked = asked;
  return orientation;
}

}  // namespace mjforge::placing
