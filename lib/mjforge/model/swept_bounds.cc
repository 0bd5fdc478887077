// Bounds of an object over the ranges of its joints. For a hinge, computes an upper bound of the
// shapes' support function over all angles of the hinge.

#include "mjforge/model/swept_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mjforge/model/forward_kinematics.h"

namespace mjforge::model {
namespace {

using Eigen::Vector3d;

// A shape and its pose in the object's frame W, with all joints at zero. SweepJoint() replaces
// shapes by a box along the axes of W, because SweptBounds() returns a box along these axes.
struct PlacedShape {
  Shape shape;
  Pose X;
  const solid::Extent* extent = nullptr;  // replaces `shape` if not null
};
using Shapes = std::vector<PlacedShape>;

double SupportOf(const Shapes& shapes, const Vector3d& direction) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& [shape, X, extent] : shapes) {
    const Vector3d along = X.q.conjugate() * direction;
    const double own = extent != nullptr ? solid::Support(*extent, along) : Support(shape, along);
    largest = std::max(largest, direction.dot(X.p) + own);
  }
  return largest;
}

Box3 BoxOf(const PlacedShape& placed, const Pose& X) {
  return placed.extent != nullptr ? BoundsOf(*placed.extent, X) : BoundsOf(placed.shape, X);
}

// Returns an upper bound of the distance between `p` and any point of the shapes. The bound is
// exact for spheres and boxes.
double RadiusAbout(const Vector3d& p, const Shapes& shapes) {
  double largest = 0;
  for (const PlacedShape& placed : shapes) {
    const auto& [shape, X, extent] = placed;
    const Box3 box = BoxOf(placed, Pose());
    const Vector3d q = X.Inverse() * p;
    const Vector3d corner = (q - box.min).cwiseAbs().cwiseMax((q - box.max).cwiseAbs());
    const bool is_sphere = extent == nullptr && shape.type == GeomType::kSphere;
    largest = std::max(largest, is_sphere ? q.norm() + shape.size.x() : corner.norm());
  }
  return largest;
}

// Inverse rotations of a hinge at both ends of its range and at angles between the ends.
struct Turns {
  std::vector<Eigen::Quaterniond> back;
  double excess = 0;  // upper bound of a + b - 1 in SweptSupport()
};

Turns TurnsOf(const Vector3d& axis, const Eigen::Vector2d& angles) {
  constexpr double kWidestArc = std::numbers::pi / 18;
  const double range = angles[1] - angles[0];
  const int arcs = std::max(3, static_cast<int>(std::ceil(range / kWidestArc)));
  Turns turns;
  for (int i = 0; i <= arcs; ++i)
    turns.back.push_back(FromAxisAngle(axis, -(angles[0] + range * i / arcs)));
  turns.excess = 1 / std::cos(range / arcs / 2) - 1;
  return turns;
}

// Returns an upper bound of the support function in `direction` over all angles of a hinge whose
// axis passes through the origin.
//
// Turning the shapes has the same effect as turning `direction` by the opposite angle. The turned
// direction moves on a cone about the axis. The range is divided into arcs of angle w. Let d1 and
// d2 be the directions at the ends of an arc, and c their common component along the axis. Every
// direction on the arc is d = a d1 + b d2 - (a + b - 1) c with a, b >= 0 and
// 1 <= a + b <= 1 / cos(w / 2). The support function h is convex and positively homogeneous;
// therefore h(d) <= a h(d1) + b h(d2) + (a + b - 1) h(-c).
double SweptSupport(const Shapes& shapes, const Vector3d& axis, const Turns& turns,
                    const Vector3d& direction) {
  const Vector3d along = axis * axis.dot(direction);
  if ((direction - along).norm() < 1e-12) return SupportOf(shapes, direction);
  double largest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Quaterniond& back : turns.back)
    largest = std::max(largest, SupportOf(shapes, back * direction));
  return largest +
         turns.excess * (std::max(largest, 0.0) + std::max(SupportOf(shapes, -along), 0.0));
}

// Returns the lower and upper bound of the shapes along a unit vector while one joint moves. The
// origin is the anchor of the joint; `turns` is used only for hinges.
Eigen::Vector2d SweptInterval(const Shapes& shapes, const Joint& joint, const Vector3d& axis,
                              const Turns& turns, const Vector3d& unit) {
  if (joint.type == "hinge")
    return {-SweptSupport(shapes, axis, turns, -unit), SweptSupport(shapes, axis, turns, unit)};
  const Eigen::Vector2d still(-SupportOf(shapes, -unit), SupportOf(shapes, unit));
  if (joint.type == "ball") {
    const double radius = RadiusAbout(Vector3d::Zero(), shapes);
    const double angle =
        joint.range ? std::min((*joint.range)[1], std::numbers::pi) : std::numbers::pi;
    const double way = 2 * radius * std::sin(angle / 2);
    return {std::max(still[0] - way, -radius), std::min(still[1] + way, radius)};
  }
  const Eigen::Vector2d ways = DisplacementsOf(joint) * axis.dot(unit);
  return {still[0] + ways.minCoeff(), still[1] + ways.maxCoeff()};
}

// Replaces the shapes by one box that contains them at all positions of the joint.
void SweepJoint(const Joint& joint, const Pose& X_WB, Shapes& shapes) {
  const Vector3d anchor = X_WB * joint.pos;
  const Vector3d axis = X_WB.q * joint.axis.stableNormalized();
  for (PlacedShape& placed : shapes) placed.X.p -= anchor;
  const Turns turns = joint.type == "hinge" ? TurnsOf(axis, DisplacementsOf(joint)) : Turns();
  Box3 box;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d interval = SweptInterval(shapes, joint, axis, turns, Vector3d::Unit(i));
    box.min[i] = interval[0] + anchor[i];
    box.max[i] = interval[1] + anchor[i];
  }
  const Shape hull = {GeomType::kBox, (box.max - box.min) / 2, nullptr};
  shapes.assign(1, {hull, Pose{.p = (box.max + box.min) / 2}});
}

bool Moves(const Joint& joint) { return joint.type != "free"; }

}  // namespace

Eigen::Vector2d DisplacementsOf(const Joint& joint) {
  constexpr double kHalfTurn = std::numbers::pi;
  const double zero = ZeroPosition(joint)[0];
  const bool is_hinge = joint.type == "hinge";
  if (is_hinge && (!joint.range || (*joint.range)[1] - (*joint.range)[0] >= 2 * kHalfTurn))
    return {-kHalfTurn, kHalfTurn};
  if (joint.range) return *joint.range - Eigen::Vector2d::Constant(zero);
  return Eigen::Vector2d::Constant(joint.start.empty() ? 0 : joint.start[0] - zero);
}

Box3 SweptBounds(const Object& object) {
  const std::vector<Body>& bodies = object.bodies;
  Box3 swept = object.bounds.aabb;
  if (!AnyJoint(object, Moves)) return swept;
  const auto collides = [](const Part& part) { return part.role != Role::kVisual; };
  const bool some_collide = std::ranges::any_of(
      bodies, [&](const Body& body) { return std::ranges::any_of(body.parts, collides); });
  const std::vector<Pose> X_WB = ZeroPoses(bodies);
  std::vector<Shapes> shapes(bodies.size());  // shapes of each body and its descendants
  for (std::size_t i = bodies.size(); i-- > 0;) {
    const Body& body = bodies[i];
    for (const Part& part : body.parts) {
      if (some_collide && !collides(part)) continue;
      if (!part.extent)
        shapes[i].push_back({part.shape, X_WB[i] * part.X_BG});
      else if (!part.extent->empty())
        shapes[i].push_back({part.shape, X_WB[i] * part.X_BG * part.X_GS, part.extent.get()});
    }
    if (shapes[i].empty()) continue;
    for (std::size_t j = body.joints.size(); j-- > 0;) {
      if (Moves(body.joints[j])) SweepJoint(body.joints[j], X_WB[i], shapes[i]);
    }
    if (body.parent < 0) {
      for (const PlacedShape& placed : shapes[i]) swept.Add(BoxOf(placed, placed.X));
    } else {
      Shapes& parent = shapes[static_cast<std::size_t>(body.parent)];
      parent.insert(parent.end(), shapes[i].begin(), shapes[i].end());
    }
    shapes[i] = {};
  }
  return swept;
}

}  // namespace mjforge::model
