// Orientation in which a body is placed, and a test whether the body would tip over.

#include "mjforge/placing/orientation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mjforge/placing/stable_poses.h"
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

// Returns the height of the body's centre of mass above the ground after a rotation that turns the
// direction `down_L` down, m.
double CenterHeight(const Orientation& of, const Vector3d& down_L) {
  double lowest = -std::numeric_limits<double>::infinity();
  for (const distance::PlacedShape& placed : of.placed)
    lowest = std::max(lowest, down_L.dot(distance::FarthestPoint(placed, down_L)));
  return lowest - down_L.dot(of.q_LB * of.p_BCm);
}

// Returns true if, in the modelled orientation, the centre of mass of the body is above the convex
// hull of its points that touch the ground, and does not sink when the body is tilted a little: on
// a rounded end, or on an apex, it would sink.
bool IsStable(const Orientation& upright) {
  constexpr double kTouching = 1e-4;  // m; higher points do not touch the ground
  constexpr double kTilt = 0.02;      // rad
  constexpr int kDirections = 8;
  constexpr double kRounding = 1e-9;  // m
  if (!solid::ConvexContains(FootprintOf(upright.placed, kTouching).Outline(),
                             upright.p_BCm.head<2>()))
    return false;
  const double height = CenterHeight(upright, -Vector3d::UnitZ());
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDirections;
    const Vector3d down(std::sin(kTilt) * std::cos(angle), std::sin(kTilt) * std::sin(angle),
                        -std::cos(kTilt));
    if (CenterHeight(upright, down) < height - kRounding) return false;
  }
  return true;
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
