// Convex cells of a partition, clipping of polygons by cells, and subtraction of a cell from convex
// polyhedra.

#include "mjforge/solid/convex_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "mjforge/solid/convex_partition.h"

namespace mjforge::solid {
namespace {

using Eigen::Vector3d;

Cell CellOf(const std::vector<Point2>& corners, const SectionPlane& plane) {
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  Cell cell;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 normal = OutwardNormal(corners, i);
    cell.sides.push_back({plane.At(normal, 0), normal.dot(corners[i])});
    cell.box.extend(plane.At(corners[i], -kUnbounded));
    cell.box.extend(plane.At(corners[i], kUnbounded));
  }
  return cell;
}

void AddNewPoint(const Vector3d& p, double near, std::vector<Vector3d>& points) {
  const auto is_same = [&](const Vector3d& other) { return (p - other).norm() <= near; };
  if (std::ranges::none_of(points, is_same)) points.push_back(p);
}

/// Moves a point onto a nearby plane if the plane is perpendicular to a coordinate axis, so that
/// boxes have exactly the coordinates of the outlines that cut them.
Vector3d OnPlane(Vector3d p, const HalfSpace& half) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(half.normal[i]) == 1) p[i] = half.limit * half.normal[i];
  }
  return p;
}

/// Sorts the corners of a convex polygon counter-clockwise about its normal.
void SortAround(const Vector3d& normal, SpacePolygon& corners) {
  Vector3d center = Vector3d::Zero();
  for (const Vector3d& p : corners) center += p / static_cast<double>(corners.size());
  const Vector3d x = normal.unitOrthogonal();
  const Vector3d y = normal.cross(x);
  std::ranges::sort(corners, {}, [&](const Vector3d& p) {
    return std::atan2(y.dot(p - center), x.dot(p - center));
  });
}

/// Clips a convex polyhedron, given by its faces, and closes the cut with a new face.
void Clip(const HalfSpace& half, double near, std::vector<SpacePolygon>& faces) {
  const auto is_outside = [&](const Vector3d& p) { return half.normal.dot(p) - half.limit > near; };
  const auto reaches_out = [&](const SpacePolygon& face) {
    return std::ranges::any_of(face, is_outside);
  };
  if (std::ranges::none_of(faces, reaches_out)) return;
  SpacePolygon lid;
  std::vector<SpacePolygon> rest;
  for (const SpacePolygon& face : faces) {
    SpacePolygon clipped = Clipped(face, half, near);
    for (const Vector3d& p : clipped) {
      if (std::abs(half.normal.dot(p) - half.limit) <= near) AddNewPoint(p, near, lid);
    }
    if (clipped.size() >= 3) rest.push_back(std::move(clipped));
  }
  faces = std::move(rest);
  if (faces.empty() || lid.size() < 3) return;
  SortAround(half.normal, lid);
  faces.push_back(std::move(lid));
}

std::vector<SpacePolygon> FacesOf(const Polytope& polytope) {
  std::vector<SpacePolygon> faces;
  for (const Polytope::Face& face : polytope.faces)
    faces.push_back(PointsAt(polytope.vertices, face.corners));
  return faces;
}

/// Returns the hull of the corners of all faces; nullopt if the hull is thinner than about `near`,
/// m.
std::optional<Polytope> PolytopeOf(const std::vector<SpacePolygon>& faces, double near) {
  std::vector<Vector3d> vertices;
  for (const SpacePolygon& face : faces) {
    for (const Vector3d& p : face) AddNewPoint(p, near, vertices);
  }
  Fault unused;
  std::optional<Polytope> hull = HullOf(vertices, unused);
  if (!hull) return std::nullopt;
  const double size = BoxAround(hull->vertices).diagonal().norm();
  if (RoundedMass(*hull, 0).volume <= near * size * size) return std::nullopt;
  return hull;
}

}  // namespace

Vector3d SectionPlane::At(const Point2& p, double along) const {
  Vector3d point;
  point[u] = p.x();
  point[v] = p.y();
  point[axis] = along;
  return point;
}

std::vector<Cell> CellsOf(const Area& area, const SectionPlane& plane) {
  std::vector<Cell> cells;
  for (const std::vector<Point2>& polygon : ConvexPolygonsOf(area))
    cells.push_back(CellOf(polygon, plane));
  return cells;
}

SpacePolygon Clipped(const SpacePolygon& polygon, const HalfSpace& half, double near) {
  const auto beyond = [&](const Vector3d& p) {
    const double distance = half.normal.dot(p) - half.limit;
    return std::abs(distance) <= near ? 0.0 : distance;
  };
  SpacePolygon rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3d& a = polygon[i];
    const Vector3d& b = polygon[(i + 1) % polygon.size()];
    const double at_a = beyond(a);
    const double at_b = beyond(b);
    if (at_a <= 0) rest.push_back(a);
    if (at_a * at_b < 0) rest.push_back(OnPlane(a + (b - a) * (at_a / (at_a - at_b)), half));
  }
  return rest;
}

double AreaOf(const SpacePolygon& polygon) {
  Vector3d twice = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  return twice.norm() / 2;
}

bool IsThin(const SpacePolygon& polygon, double width) {
  double around = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    around += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
  return AreaOf(polygon) <= width * around;
}

std::vector<SpacePolygon> ClippedByCells(const std::vector<SpacePolygon>& polygons,
                                         const std::vector<Cell>& cells, const Vector3d& offset) {
  constexpr double kOnPlane = 0.01;  // tolerance as a share of the offset
  std::vector<SpacePolygon> parts;
  for (const SpacePolygon& polygon : polygons) {
    Eigen::AlignedBox3d box = BoxAround(polygon);
    box.translate(offset);
    for (const Cell& cell : cells) {
      if (!cell.box.intersects(box)) continue;
      SpacePolygon part = polygon;
      for (const HalfSpace& side : cell.sides) {
        if (part.size() < 3) break;
        part = Clipped(part, {side.normal, side.limit - side.normal.dot(offset)},
                       kOnPlane * offset.norm());
      }
      if (part.size() >= 3 && !IsThin(part, offset.norm())) parts.push_back(std::move(part));
    }
  }
  return parts;
}

bool Subtract(const Cell& cell, std::vector<Polytope>& polyhedra, double near, std::size_t most) {
  std::vector<Polytope> rest;
  for (Polytope& polyhedron : polyhedra) {
    std::vector<SpacePolygon> faces = FacesOf(polyhedron);
    std::vector<SpacePolygon> inside = faces;
    if (cell.box.intersects(BoxAround(polyhedron.vertices))) {
      for (const HalfSpace& side : cell.sides) Clip(side, near, inside);
    } else {
      inside.clear();
    }
    if (!PolytopeOf(inside, near)) {
      rest.push_back(std::move(polyhedron));
      continue;
    }
    for (const HalfSpace& side : cell.sides) {
      std::vector<SpacePolygon> outside = faces;
      Clip({-side.normal, -side.limit}, near, outside);
      if (std::optional<Polytope> part = PolytopeOf(outside, near))
        rest.push_back(*std::move(part));
      Clip(side, near, faces);
    }
    if (rest.size() > most) return false;
  }
  polyhedra = std::move(rest);
  return true;
}

}  // namespace mjforge::solid
