// Joins convex polyhedra at common faces, and counts connected components, by a search for faces of
// two polyhedra in one plane.

#include "mjforge/solid/joined_polyhedra.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "mjforge/solid/convex_cells.h"

namespace mjforge::solid {
namespace {

using Eigen::Vector3d;

double LimitOf(const Polytope& polytope, const Polytope::Face& face) {
  return face.normal.dot(polytope.vertices[static_cast<std::size_t>(face.corners[0])]);
}

/// A polyhedron and its bounding box, which is enough to reject most pairs.
struct Bounded {
  Polytope polytope;
  Eigen::AlignedBox3d box;

  explicit Bounded(Polytope polyhedron)
      : polytope(std::move(polyhedron)), box(BoxAround(polytope.vertices)) {}
};

bool IsNear(const Bounded& a, const Bounded& b, double near) {
  return a.box.exteriorDistance(b.box) <= near;
}

/// Returns a face of a and a face of b that are in one plane, with a and b on opposite sides of
/// this plane; nullopt if there are none.
std::optional<std::pair<std::size_t, std::size_t>> CommonPlane(const Polytope& a, const Polytope& b,
                                                               double near) {
  constexpr double kOpposite = 1e-9;
  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    for (std::size_t j = 0; j < b.faces.size(); ++j) {
      const Polytope::Face& f = a.faces[i];
      const Polytope::Face& g = b.faces[j];
      if ((f.normal + g.normal).norm() > kOpposite) continue;
      if (std::abs(LimitOf(a, f) + LimitOf(b, g)) <= near) return std::pair(i, j);
    }
  }
  return std::nullopt;
}

/// Returns true if all vertices of b are on the inner side of all faces of a, except for the face
/// `but`.
bool IsWithin(const Polytope& b, const Polytope& a, std::size_t but, double near) {
  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    if (i == but) continue;
    const double limit = LimitOf(a, a.faces[i]) + near;
    for (const Vector3d& p : b.vertices) {
      if (a.faces[i].normal.dot(p) > limit) return false;
    }
  }
  return true;
}

/// Returns the area of the common face of a and b if their union is convex; otherwise nullopt. The
/// union is convex if each polyhedron is on the inner side of all other faces of the other
/// polyhedron.
std::optional<double> AreaBetween(const Polytope& a, const Polytope& b, double near) {
  const auto common = CommonPlane(a, b, near);
  if (!common || !IsWithin(b, a, common->first, near) || !IsWithin(a, b, common->second, near))
    return std::nullopt;
  return AreaOf(PointsAt(a.vertices, a.faces[common->first].corners));
}

struct Pair {
  std::size_t a = 0;
  std::size_t b = 0;
  float area = 0;  // in single precision, so that equal areas are equal despite rounding errors
};

std::vector<Pair> ConvexPairs(const std::vector<Bounded>& bodies, double near) {
  std::vector<Pair> pairs;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (!IsNear(bodies[a], bodies[b], near)) continue;
      const auto area = AreaBetween(bodies[a].polytope, bodies[b].polytope, near);
      if (area) pairs.push_back({a, b, static_cast<float>(*area)});
    }
  }
  std::ranges::stable_sort(pairs, std::ranges::greater(), &Pair::area);
  return pairs;
}

std::optional<Bounded> UnionOf(const Polytope& a, const Polytope& b) {
  std::vector<Vector3d> vertices = a.vertices;
  vertices.insert(vertices.end(), b.vertices.begin(), b.vertices.end());
  Fault unused;
  std::optional<Polytope> hull = HullOf(vertices, unused);
  if (!hull) return std::nullopt;
  return Bounded(*std::move(hull));
}

/// Returns true if a face of a and a face of b are in one plane and overlap in an area.
bool ShareArea(const Polytope& a, const Polytope& b, double near) {
  const auto common = CommonPlane(a, b, near);
  if (!common) return false;
  const Polytope::Face& face = b.faces[common->second];
  const SpacePolygon around = PointsAt(b.vertices, face.corners);
  SpacePolygon shared = PointsAt(a.vertices, a.faces[common->first].corners);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Vector3d& from = around[i];
    const Vector3d normal =
        (around[(i + 1) % around.size()] - from).cross(face.normal).normalized();
    shared = Clipped(shared, {normal, normal.dot(from)}, near);
  }
  return !IsThin(shared, near);
}

}  // namespace

void JoinPolyhedra(std::vector<Polytope>& polyhedra, double near) {
  std::vector<Bounded> bodies;
  bodies.reserve(polyhedra.size());
  for (Polytope& polyhedron : polyhedra) bodies.emplace_back(std::move(polyhedron));
  while (true) {
    std::vector<bool> is_joined(bodies.size());
    std::vector<bool> is_gone(bodies.size());
    bool has_joined = false;
    for (const auto& [a, b, area] : ConvexPairs(bodies, near)) {
      if (is_joined[a] || is_joined[b]) continue;
      std::optional<Bounded> both = UnionOf(bodies[a].polytope, bodies[b].polytope);
      if (!both) continue;
      bodies[a] = *std::move(both);
      is_joined[a] = is_joined[b] = is_gone[b] = has_joined = true;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!is_gone[i]) std::swap(bodies[kept++], bodies[i]);
    }
    bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(kept), bodies.end());
    if (!has_joined) break;
  }
  polyhedra.clear();
  for (Bounded& body : bodies) polyhedra.push_back(std::move(body.polytope));
}

std::size_t CountSeparateParts(const std::vector<Polytope>& polyhedra, double near) {
  std::vector<Bounded> bodies(polyhedra.begin(), polyhedra.end());
  std::vector<std::size_t> group(bodies.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::size_t count = bodies.size();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (group[a] == group[b] || !IsNear(bodies[a], bodies[b], near)) continue;
      if (!ShareArea(bodies[a].polytope, bodies[b].polytope, near)) continue;
      std::ranges::replace(group, std::size_t{group[b]}, std::size_t{group[a]});
      --count;
    }
  }
  return count;
}

}  // namespace mjforge::solid
