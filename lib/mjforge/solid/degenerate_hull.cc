// Hulls of points in a plane, on a line or at one place, which are the cores of rounded slabs,
// capsules and balls. Also removes the repeated vertices of their meshes.

#include <algorithm>
#include <map>

#include "mjforge/solid/polytope.h"

namespace mjforge::solid {
namespace {

using Eigen::Vector3d;

constexpr double kFlat = 1e-9;  // tolerance for points in one plane or line, relative to the size

/// Returns the first of the points at which `measure` is largest, up to rounding, so that the
/// choice does not depend on the processor.
template <typename Measure>
Vector3d FarthestOf(std::span<const Vector3d> points, const Measure& measure) {
  double largest = 0;
  for (const Vector3d& p : points) largest = std::max(largest, measure(p));
  return *std::ranges::find_if(
      points, [&](const Vector3d& p) { return measure(p) >= (1 - kFlat) * largest; });
}

/// Corner of a polygon, and the outward normal of the side from this corner to the next. Corners
/// may coincide.
struct Side {
  Vector3d corner;
  Vector3d outward;
};

/// Returns a polygon as a prism of height 0, whose upper face has the normal `up`.
Polytope FlatPrism(const std::vector<Side>& sides, const Vector3d& up) {
  Polytope flat;
  const int count = static_cast<int>(sides.size());
  for (int end = 0; end < 2; ++end) {
    for (const Side& side : sides) flat.vertices.push_back(side.corner);
  }
  Polytope::Face above{{}, up};
  Polytope::Face below{{}, -up};
  for (int i = 0; i < count; ++i) {
    above.corners.push_back(i);
    below.corners.push_back(2 * count - 1 - i);
    const int next = (i + 1) % count;
    flat.faces.push_back(
        {{count + i, count + next, next, i}, sides[static_cast<std::size_t>(i)].outward});
  }
  flat.faces.push_back(above);
  flat.faces.push_back(below);
  return flat;
}

}  // namespace

FlatHull FlatHullOf(std::span<const Vector3d> points) {
  const Vector3d& a = points.front();
  const Vector3d b = FarthestOf(points, [&](const Vector3d& p) { return (p - a).norm(); });
  const double size = (b - a).norm();
  const double least = kFlat * std::max({size, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()});
  const Vector3d x = size <= least ? Vector3d::UnitX() : Vector3d((b - a) / size);
  const auto across = [&](const Vector3d& p) { return Vector3d(p - a - (p - a).dot(x) * x); };
  const Vector3d c = FarthestOf(points, [&](const Vector3d& p) { return across(p).norm(); });
  const bool is_line = across(c).norm() <= least;
  const Vector3d y = is_line ? x.unitOrthogonal() : Vector3d(across(c).normalized());
  const Vector3d up = x.cross(y);
  std::vector<Point2> flat;
  for (const Vector3d& p : points) flat.emplace_back((p - a).dot(x), is_line ? 0 : (p - a).dot(y));
  const auto at = [&](const Point2& p) { return Vector3d(a + p.x() * x + p.y() * y); };
  if (is_line) {
    const auto [low, high] = std::ranges::minmax(flat, {}, [](const Point2& p) { return p.x(); });
    const Vector3d from = at(low);
    const Vector3d to = size <= least ? from : at(high);
    return {FlatPrism({{from, -y}, {to, x}, {to, y}, {from, -x}}, up), std::pair(from, to)};
  }
  const std::vector<Point2> corners = ConvexPolygonOf(std::move(flat), kFlat);
  std::vector<Side> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 outward = OutwardNormal(corners, i);
    sides.push_back({at(corners[i]), outward.x() * x + outward.y() * y});
  }
  return {FlatPrism(sides, up), std::nullopt};
}

void RemoveRepeats(TriangleMesh& mesh) {
  std::map<std::array<double, 6>, int> places;
  std::vector<int> kept_as;
  TriangleMesh kept;
  kept.in_micrometres = mesh.in_micrometres;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vector3d& p = mesh.vertices[i];
    const Vector3d& n = mesh.normals[i];
    const auto [place, is_new] = places.try_emplace({p.x(), p.y(), p.z(), n.x(), n.y(), n.z()},
                                                    static_cast<int>(kept.vertices.size()));
    kept_as.push_back(place->second);
    if (!is_new) continue;
    kept.vertices.push_back(p);
    kept.normals.push_back(n);
  }
  for (std::array<int, 3> triangle : mesh.triangles) {
    for (int& corner : triangle) corner = kept_as[static_cast<std::size_t>(corner)];
    const auto& [i, j, k] = triangle;
    if (i != j && j != k && k != i) kept.triangles.push_back(triangle);
  }
  mesh = std::move(kept);
}

}  // namespace mjforge::solid
