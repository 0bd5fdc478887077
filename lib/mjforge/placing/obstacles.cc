// Distances to obstacles: broad phase by bounding boxes of bodies and parts, and conservative
// advancement.

#include "mjforge/placing/obstacles.h"

#include <algorithm>
#include <cmath>

namespace mjforge::placing {
namespace {

using distance::PlacedShape;
using Eigen::Vector3d;

constexpr double kLengthRounding = 1e-9;  // m
constexpr double kTouch = 1e-7;           // m; shapes within this distance touch
constexpr int kMostSteps = 200;

// Returns true if the boxes are farther apart than a distance.
inline bool AreFarther(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b,
                       double distance) {
  // Tests single axes first, because most boxes are far apart along one axis.
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (a.min()(i) - b.max()(i) > distance || b.min()(i) - a.max()(i) > distance) return true;
  }
  return distance > 0 && a.squaredExteriorDistance(b) > distance * distance;
}

// Returns true if the shape has no point above the support.
bool IsBelow(const PlacedShape& placed, const Support& support) {
  const Vector3d top = distance::FarthestPoint(placed, support.up_W);
  return support.up_W.dot(top - support.p_W) <= kLengthRounding;
}

bool IsBox(const PlacedShape& placed) { return placed.shape.type == model::GeomType::kBox; }

// Returns the distance by which a shape can be moved in the direction -up_W until it touches
// another shape, at most `most`, m.
//
// Conservative advancement along a line: the plane through the nearest point of the fixed shape,
// perpendicular to the shortest connection, separates both shapes until the moving shape reaches it
// (van den Bergen, "Ray casting against general convex objects with application to continuous
// collision detection", 2004).
double DropOf(PlacedShape moving, const PlacedShape& fixed, const Vector3d& up_W, double most) {
  double drop = 0;
  for (int i = 0; i < kMostSteps; ++i) {
    const Vector3d apart = distance::Separation(moving, fixed);
    const double distance = apart.norm();
    if (distance <= kTouch) return drop;
    const double approach = apart.dot(up_W) / distance;  // per length of the motion
    if (approach * (most - drop) <= distance) return most;
    const double step = distance / approach;
    drop += step;
    moving.X_WG.p -= step * up_W;
    moving.box_W.translate(Vector3d(-step * up_W));
  }
  return drop;
}

PlacedShape CylinderAt(const model::Pose& X_WG, double radius, double half_height) {
  return {{.type = model::GeomType::kCylinder, .size = {radius, half_height, 0}}, X_WG};
}

// Returns the radius to which a cylinder can be widened until it touches a shape, at most `most`,
// m. Uses conservative advancement: the distance shrinks by no more than the radius grows.
double FreeRadiusBeside(const PlacedShape& fixed, const model::Pose& X_WCylinder,
                        double half_height, double most) {
  constexpr double kNear = 1e-5;   // m
  constexpr double kLeast = 1e-3;  // m; libccd is not reliable with thinner cylinders
  double radius = kLeast;
  for (int i = 0; i < kMostSteps; ++i) {
    const double distance = distance::Distance(CylinderAt(X_WCylinder, radius, half_height), fixed);
    if (distance <= kNear) return radius > kLeast ? radius : 0;
    radius += distance;
    if (radius >= most) return most;
  }
  return radius;
}

}  // namespace

PlacedShapes ShapesAt(std::span<const BodyShape> shapes, const model::Pose& X_WA) {
  PlacedShapes placed;
  placed.reserve(shapes.size());
  for (const BodyShape& of : shapes) placed.emplace_back(of.shape, X_WA * of.X_AG);
  return placed;
}

MovedShapes::MovedShapes(std::span<const PlacedShape> shapes_L, const model::Pose& X_WL)
    : shapes_L_(shapes_L), X_WL_(X_WL) {
  const Eigen::Matrix3d R_WL = X_WL.q.toRotationMatrix();
  const Vector3d spare = Vector3d::Constant(kLengthRounding);
  boxes_W_.reserve(shapes_L.size());
  for (const PlacedShape& shape : shapes_L) {
    const Vector3d center = X_WL.p + R_WL * shape.box_W.center();
    const Vector3d half = R_WL.cwiseAbs() * (shape.box_W.sizes() / 2) + spare;
    box_W_.extend(boxes_W_.emplace_back(center - half, center + half));
  }
}

PlacedShape MovedShapes::At(std::size_t index) const {
  return {shapes_L_[index].shape, X_WL_ * shapes_L_[index].X_WG};
}

void Obstacles::Add(const model::Object& object, int body, double clear) {
  const std::vector<BodyShape> shapes = ShapesBelow(object, body);
  const PlacedShapes placed = ShapesAt(shapes, PoseInWorld(object, body));
  Group group{body, clear, distance::BoxAround(placed), {}};
  for (std::size_t i = 0; i < shapes.size(); ++i)
    group.obstacles.push_back({shapes[i].body, placed[i]});
  groups_.push_back(std::move(group));
}

std::optional<Blocker> Obstacles::FindBlocker(const MovedShapes& shapes, double clear,
                                              const Support& support) const {
  for (const Group& group : groups_) {
    const double asked = std::max(clear, group.clear);
    if (AreFarther(group.box_W, shapes.box_W(), asked)) continue;
    for (const auto& [body, obstacle] : group.obstacles) {
      if (support.is_ignored && body == support.body) continue;
      if (AreFarther(obstacle.box_W, shapes.box_W(), asked)) continue;
      const bool may_touch = asked > 0 && (body == support.body || IsBelow(obstacle, support) ||
                                           std::ranges::count(support.below, body) > 0);
      const double wanted = may_touch ? 0 : asked;
      for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (AreFarther(obstacle.box_W, shapes.box_W(i), wanted)) continue;
        const PlacedShape placed = shapes.At(i);
        if (AreFarther(obstacle.box_W, placed.box_W, wanted - kLengthRounding)) continue;
        const double distance = distance::DistanceUpTo(wanted, placed, obstacle);
        if (distance > 0 && distance >= wanted - kLengthRounding) continue;
        return Blocker{body, distance};
      }
    }
  }
  return std::nullopt;
}

int Obstacles::FindOverlap(std::span<const PlacedShape> shapes, std::span<const int> bodies) const {
  const Eigen::AlignedBox3d box_W = distance::BoxAround(shapes);
  const auto overlaps = [&](const Obstacle& obstacle) {
    return std::ranges::any_of(shapes, [&](const PlacedShape& shape) {
      return obstacle.shape.box_W.intersects(shape.box_W) &&
             distance::Distance(shape, obstacle.shape) <= 0;
    });
  };
  for (const Group& group : groups_) {
    if (std::ranges::find(bodies, group.body) == bodies.end()) continue;
    if (group.box_W.intersects(box_W) && std::ranges::any_of(group.obstacles, overlaps))
      return group.body;
  }
  return -1;
}

double Obstacles::FreeRadius(const model::Pose& X_WCylinder, double half_height, double most,
                             const Support& support) const {
  const PlacedShape widest = CylinderAt(X_WCylinder, most, half_height);
  for (const Group& group : groups_) {
    if (!group.box_W.intersects(widest.box_W)) continue;
    for (const auto& [body, obstacle] : group.obstacles) {
      if (body == support.body || !obstacle.box_W.intersects(widest.box_W)) continue;
      if (!IsBelow(obstacle, support))
        most = FreeRadiusBeside(obstacle, X_WCylinder, half_height, most);
    }
  }
  return most;
}

double Obstacles::Drop(PlacedShapes shapes, const Vector3d& up_W, double most) const {
  double drop = most;
  const auto swept = [&](Eigen::AlignedBox3d box_W) {
    const Eigen::AlignedBox3d end = box_W.translated(Vector3d(-drop * up_W));
    return box_W.extend(end);
  };
  const Eigen::AlignedBox3d box_W = distance::BoxAround(shapes);
  for (const Group& group : groups_) {
    if (!group.box_W.intersects(swept(box_W))) continue;
    for (const auto& [body, obstacle] : group.obstacles) {
      if (!obstacle.box_W.intersects(swept(box_W))) continue;
      for (const PlacedShape& placed : shapes) {
        if (obstacle.box_W.intersects(swept(placed.box_W)))
          drop = DropOf(placed, obstacle, up_W, drop);
      }
    }
  }
  return drop;
}

std::vector<Contact> Obstacles::FindContacts(std::span<const PlacedShape> shapes,
                                             double within) const {
  std::vector<Contact> contacts;
  const Eigen::AlignedBox3d box_W = distance::BoxAround(shapes);
  for (const Group& group : groups_) {
    if (AreFarther(group.box_W, box_W, within)) continue;
    for (const auto& [body, obstacle] : group.obstacles) {
      if (AreFarther(obstacle.box_W, box_W, within)) continue;
      for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (AreFarther(obstacle.box_W, shapes[i].box_W, within)) continue;
        const Vector3d apart = distance::Separation(shapes[i], obstacle);
        const double distance = apart.norm();
        if (distance <= 0 || distance > within) continue;
        contacts.push_back(
            {body, &obstacle, i, IsBox(shapes[i]) && IsBox(obstacle), apart / distance});
      }
    }
  }
  return contacts;
}

std::pair<double, double> Obstacles::HeightsOf(int body, const Support& support) const {
  std::pair<double, double> heights;
  for (const Group& group : groups_) {
    for (const auto& [of, obstacle] : group.obstacles) {
      if (of != body) continue;
      for (const double sign : {-1.0, 1.0}) {
        const Vector3d p_W = distance::FarthestPoint(obstacle, sign * support.up_W);
        const double height = support.up_W.dot(p_W - support.p_W);
        heights = {std::min(heights.first, height), std::max(heights.second, height)};
      }
    }
  }
  return heights;
}

}  // namespace mjforge::placing
