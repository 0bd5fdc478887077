#include "mjforge/physics/touching.h"

#include <ccd/ccd.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "mjforge/physics/solids.h"

namespace mjforge::physics {
namespace {

// libccd's tolerances are absolute, for shapes of size 1.
constexpr double kTolerance = 1e-4;
constexpr unsigned long kMostIterations = 200;
constexpr double kHullTolerance = 1e-3;  // of the size, where a point is asked for

/// The convex hull of solids and of all within a distance of it, in units of
/// `scale` about `origin`.
struct Hull {
  std::span<const model::Part> solids;
  double around = 0;  // m
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double scale = 1;  // m
};

Eigen::Vector3d FarthestPoint(const Hull& hull, const Eigen::Vector3d& direction) {
  Eigen::Vector3d farthest = Eigen::Vector3d::Zero();
  double distance = -std::numeric_limits<double>::infinity();
  for (const model::Part& solid : hull.solids) {
    const Eigen::Vector3d p =
        solid.X_BG.p +
        solid.X_BG.q * model::SupportPoint(solid.shape, solid.X_BG.q.conjugate() * direction);
    if (p.dot(direction) <= distance) continue;
    distance = p.dot(direction);
    farthest = p;
  }
  return (farthest + hull.around * direction.stableNormalized() - hull.origin) / hull.scale;
}

void HullSupport(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Eigen::Vector3d p =
      FarthestPoint(*static_cast<const Hull*>(object), Eigen::Vector3d(direction->v));
  ccdVec3Set(point, p.x(), p.y(), p.z());
}

void PointSupport(const void* object, const ccd_vec3_t* /*direction*/, ccd_vec3_t* point) {
  const auto& p = *static_cast<const Eigen::Vector3d*>(object);
  ccdVec3Set(point, p.x(), p.y(), p.z());
}

bool Intersect(const void* a, ccd_support_fn support_a, const void* b, ccd_support_fn support_b) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = support_a;
  ccd.support2 = support_b;
  ccd.max_iterations = kMostIterations;
  ccd.dist_tolerance = kTolerance;
  return ccdGJKIntersect(a, b, &ccd) != 0;
}

model::Box3 BoxOf(const model::Part& solid) { return model::BoundsOf(solid.shape, solid.X_BG); }

bool Touch(const model::Part& a, const model::Box3& box_a, const model::Part& b,
           const model::Box3& box_b, double gap) {
  if (((box_a.min - box_b.max).array() > gap).any() ||
      ((box_b.min - box_a.max).array() > gap).any()) {
    return false;
  }
  model::Box3 box = box_a;
  box.Add(box_b);
  Hull hull_a = {.solids = std::span(&a, 1), .around = gap / 2};
  Hull hull_b = {.solids = std::span(&b, 1), .around = gap / 2};
  hull_a.origin = hull_b.origin = (box.min + box.max) / 2;
  hull_a.scale = hull_b.scale = (box.max - box.min).norm() / 2;
  return Intersect(&hull_a, HullSupport, &hull_b, HullSupport);
}

}  // namespace

bool Touch(const model::Part& a, const model::Part& b, double gap) {
  return Touch(a, BoxOf(a), b, BoxOf(b), gap);
}

std::vector<std::vector<std::size_t>> Pieces(const std::vector<model::Part>& parts, double gap) {
  const std::size_t count = parts.size();
  std::vector<std::size_t> leader(count);
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&](std::size_t i) {
    while (leader[i] != i) i = leader[i] = leader[leader[i]];
    return i;
  };
  const std::vector<model::Box3> boxes = BoxesOf(parts);
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (find(i) != find(j) && Touch(parts[i], boxes[i], parts[j], boxes[j], gap))
        leader[find(i)] = find(j);
    }
  }
  std::vector<std::vector<std::size_t>> pieces(count);
  for (std::size_t i = 0; i < count; ++i) pieces[find(i)].push_back(i);
  std::erase_if(pieces, [](const auto& piece) { return piece.empty(); });
  const auto mass = [&](const std::vector<std::size_t>& piece) {
    double sum = 0;
    for (const std::size_t i : piece) sum += parts[i].mass;
    return sum;
  };
  std::ranges::stable_sort(pieces, std::ranges::greater(), mass);
  return pieces;
}

Neighbour NearestOf(const std::vector<model::Part>& parts, const std::vector<std::size_t>& group,
                    double gap) {
  model::Box3 all;
  std::vector<model::Box3> boxes;
  for (const model::Part& part : parts) all.Add(boxes.emplace_back(BoxOf(part)));
  Neighbour nearest = {.distance = (all.max - all.min).norm()};
  for (std::size_t other = 0; other < parts.size(); ++other) {
    if (std::ranges::find(group, other) != group.end()) continue;
    for (const std::size_t own : group) {
      const auto touch = [&](double distance) {
        return Touch(parts[own], boxes[own], parts[other], boxes[other], distance);
      };
      if (!touch(nearest.distance)) continue;
      double near = gap;
      nearest.part = other;
      while (nearest.distance - near > 1e-4 * nearest.distance) {
        const double middle = (near + nearest.distance) / 2;
        (touch(middle) ? nearest.distance : near) = middle;
      }
    }
  }
  return nearest;
}

bool IsInsideHull(const std::vector<model::Part>& parts, const Eigen::Vector3d& p_B) {
  model::Box3 box;
  for (const model::Part& part : parts) box.Add(BoxOf(part));
  const double size = (box.max - box.min).norm() / 2;
  const Hull hull = {.solids = parts,
                     .around = kHullTolerance * size,
                     .origin = (box.min + box.max) / 2,
                     .scale = size};
  const Eigen::Vector3d point = (p_B - hull.origin) / hull.scale;
  return Intersect(&hull, HullSupport, &point, PointSupport);
}

}  // namespace mjforge::physics
