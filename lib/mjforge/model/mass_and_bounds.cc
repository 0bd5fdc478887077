// Sums over parts and bodies: bounds, mass properties and counts of geoms.

#include "mjforge/model/mass_and_bounds.h"

#include <algorithm>

#include "mjforge/model/forward_kinematics.h"
#include "mjforge/model/swept_bounds.h"

namespace mjforge::model {
namespace {

// Returns the bounds of all parts that `for_each` visits. `for_each` calls its argument for each
// part, with the part and its pose X_FG.
template <typename ForEach>
Bounds BoundsOfAll(const ForEach& for_each) {
  bool some_collide = false;
  for_each([&](const Part& part, const Pose&) { some_collide |= part.role != Role::kVisual; });
  Bounds bounds;
  for_each([&](const Part& part, const Pose& X_FG) {
    if (some_collide && part.role == Role::kVisual) return;
    bounds.aabb.Add(BoundsOf(part, X_FG));
    bounds.horizontal_radius = std::max(
        bounds.horizontal_radius, part.extent ? HorizontalRadius(*part.extent, X_FG * part.X_GS)
                                              : HorizontalRadius(part.shape, X_FG));
  });
  if (bounds.aabb.empty()) return bounds;
  bounds.top_offset = bounds.aabb.max[2];
  bounds.bottom_offset = bounds.aabb.min[2];
  return bounds;
}

bool IsIdentity(const Pose& X) { return X.p.isZero(0) && X.q.vec().isZero(0); }

}  // namespace

Box3 BoundsOf(const Part& part, const Pose& X_AG) {
  return part.extent ? BoundsOf(*part.extent, X_AG * part.X_GS) : BoundsOf(part.shape, X_AG);
}

Bounds DeclaredBounds(const Eigen::Vector3d& total_size) {
  Bounds bounds;
  bounds.aabb.min = -total_size;
  bounds.aabb.max = total_size;
  bounds.top_offset = bounds.aabb.max[2];
  bounds.bottom_offset = bounds.aabb.min[2];
  bounds.horizontal_radius = total_size.head<2>().norm();
  bounds.declared = true;
  return bounds;
}

Bounds BoundsOf(const std::vector<Part>& parts, std::size_t first) {
  return BoundsOfAll([&](const auto& visit) {
    for (std::size_t i = first; i < parts.size(); ++i) visit(parts[i], parts[i].X_BG);
  });
}

void ScaleMass(double factor, std::vector<Body>& bodies, std::size_t body, std::size_t first_part,
               std::size_t first_body) {
  const auto scale = [factor](std::vector<Part>& parts, std::size_t first) {
    for (std::size_t i = first; i < parts.size(); ++i) {
      parts[i].mass *= factor;
      parts[i].density = 0;  // the density does not match the mass any more
    }
  };
  scale(bodies[body].parts, first_part);
  for (std::size_t i = first_body; i < bodies.size(); ++i) {
    scale(bodies[i].parts, 0);
    bodies[i].mass_properties = Scaled(bodies[i].mass_properties, factor);
  }
}

Bounds SubtreeBounds(const std::vector<Body>& bodies, std::size_t first, std::size_t first_part,
                     std::size_t first_body) {
  const std::vector<Pose> X_FB = SubtreePoses(bodies, first);
  if (X_FB.size() == 1 && IsIdentity(X_FB[0])) return BoundsOf(bodies[first].parts, first_part);
  const std::vector<bool> is_below = InSubtree(bodies, first);
  return BoundsOfAll([&](const auto& visit) {
    for (std::size_t i = first; i < bodies.size(); ++i) {
      if (!is_below[i - first] || (i > first && i < first_body)) continue;
      const std::vector<Part>& parts = bodies[i].parts;
      for (std::size_t j = i == first ? first_part : 0; j < parts.size(); ++j)
        visit(parts[j], X_FB[i - first] * parts[j].X_BG);
    }
  });
}

MassProperties SubtreeMass(const std::vector<Body>& bodies, std::size_t first) {
  const std::vector<Pose> X_FB = SubtreePoses(bodies, first);
  MassProperties sum = bodies[first].mass_properties;
  if (!IsIdentity(X_FB[0])) sum = InFrame(X_FB[0], sum);
  const std::vector<bool> is_below = InSubtree(bodies, first);
  for (std::size_t i = first + 1; i < bodies.size(); ++i) {
    if (is_below[i - first])
      sum = Combine(sum, InFrame(X_FB[i - first], bodies[i].mass_properties));
  }
  return sum;
}

// Exists for simulators other than MuJoCo. In MuJoCo, all mass of a body with joints may be in
// bodies that are fixed to it. Other simulators treat a fixed body as a body with a fixed joint,
// and require mass on both sides of each joint.
void ShareMass(std::vector<Body>& bodies) {
  // For each body, the body M that moves it: the body itself or its nearest ancestor with joints.
  std::vector<std::size_t> movers(bodies.size());
  std::vector<Pose> X_MB(bodies.size());
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    movers[i] = i;
    if (!bodies[i].joints.empty()) continue;
    const auto parent = static_cast<std::size_t>(bodies[i].parent);
    movers[i] = movers[parent];
    X_MB[i] = X_MB[parent] * bodies[i].X_PB;
    Body& mover = bodies[movers[i]];
    if (mover.joints.empty() || mover.mass_properties.mass > 0) continue;
    if (!(bodies[i].mass_properties.mass > 0)) continue;
    bodies[i].mass_properties = Scaled(bodies[i].mass_properties, 0.5);
    mover.mass_properties = InFrame(X_MB[i], bodies[i].mass_properties);
    mover.explicit_inertial = bodies[i].explicit_inertial = true;
  }
}

std::size_t GeomCount(const Body& body) {
  std::size_t count = 0;
  for (const Part& part : body.parts) count += part.role == Role::kBoth && !part.as_is ? 2 : 1;
  return count;
}

void MeasureAtStart(Object& object) {
  object.mass_properties = SubtreeMass(object.bodies, 0);
  if (!object.bounds.declared) object.bounds = SubtreeBounds(object.bodies, 0);
  object.bounds.swept = SweptBounds(object);
}

}  // namespace mjforge::model
