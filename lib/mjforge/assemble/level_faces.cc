// Search for level upper faces: top faces of convex shapes, which are joined, and reduced where
// other shapes stand on them.

#include "mjforge/assemble/level_faces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace mjforge::assemble {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Polygon = std::vector<Vector2d>;

// Tolerance for equal heights and for contact, m: smaller than any clearance that matters, larger
// than the rounding errors of poses.
constexpr double kTouching = 1e-6;
constexpr double kStraight = 1e-9;  // sine of the angle below which a corner is left out
constexpr std::size_t kDiscCorners = 64;
// Largest number of faces that are compared with all shapes. The limit is needed because an object
// may have 40,000 parts.
constexpr std::size_t kMostFaces = 64;

// Returns the convex hull of the points, without corners on straight lines.
Polygon Simplified(Polygon points) { return solid::ConvexPolygonOf(std::move(points), kStraight); }

Polygon PolygonAround(const Vector2d& center, double radius) {
  Polygon corners;
  for (std::size_t i = 0; i < kDiscCorners; ++i) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / kDiscCorners;
    corners.emplace_back(center + radius / std::cos(std::numbers::pi / kDiscCorners) *
                                      Vector2d(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

// Replaces a disc by the largest regular polygon inside the disc.
void MakePolygon(LevelFace& face) {
  if (!face.radius) return;
  Vector2d center = Vector2d::Zero();
  for (const Vector2d& corner : face.corners) center += corner / kDiscCorners;
  for (Vector2d& corner : face.corners)
    corner = center + std::cos(std::numbers::pi / kDiscCorners) * (corner - center);
  face.radius.reset();
}

// Returns the top face of the shape's convex hull. If the top is not a level face but a point or an
// edge, the returned face has fewer than three corners.
LevelFace TopOf(const PlacedShape& placed) {
  LevelFace face{.corners = {}, .z = placed.box.max.z(), .radius = std::nullopt};
  const Vector3d axis = placed.X_WG.q * Vector3d::UnitZ();
  if (placed.shape.type == model::GeomType::kCylinder) {
    const double radius = placed.shape.size[0];
    if (axis.head<2>().norm() * radius > kTouching) return face;
    face.radius = radius;
    face.corners = PolygonAround(placed.X_WG.p.head<2>(), radius);
    return face;
  }
  for (const Vector3d& vertex : VerticesOf(placed.shape)) {
    const Vector3d p = placed.X_WG * vertex;
    if (p.z() >= face.z - kTouching) face.corners.emplace_back(p.head<2>());
  }
  face.corners = Simplified(std::move(face.corners));
  return face;
}

// Returns the convex hull of faces of equal height if the faces fill the hull; otherwise the faces.
// The faces belong to convex pieces of one part and do not overlap: they fill the hull if the sum
// of their areas equals the area of the hull.
std::vector<LevelFace> Joined(std::vector<LevelFace> faces) {
  if (faces.size() < 2) return faces;
  LevelFace whole{.corners = {}, .z = faces.front().z, .radius = std::nullopt};
  double area = 0;
  for (LevelFace& face : faces) {
    MakePolygon(face);
    area += solid::AreaOf(face.corners);
    whole.corners.insert(whole.corners.end(), face.corners.begin(), face.corners.end());
  }
  whole.corners = Simplified(std::move(whole.corners));
  if (area < (1 - 1e-6) * solid::AreaOf(whole.corners)) return faces;
  return {whole};
}

// Returns the level top faces of all shapes. Top faces of the convex pieces of one part are joined.
std::vector<LevelFace> TopFaces(std::span<const PlacedShape> shapes) {
  std::vector<LevelFace> faces;
  std::vector<LevelFace> pieces;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    LevelFace face = TopOf(shapes[i]);
    if (face.corners.size() < 3) continue;
    if (shapes[i].piece_of.empty()) {
      faces.push_back(std::move(face));
      continue;
    }
    pieces.push_back(std::move(face));
    if (i + 1 < shapes.size() && shapes[i + 1].piece_of == shapes[i].piece_of) continue;
    std::ranges::stable_sort(pieces, {}, &LevelFace::z);
    for (auto from = pieces.begin(); from != pieces.end();) {
      const auto to = std::find_if(from, pieces.end(), [&](const LevelFace& other) {
        return other.z > from->z + kTouching;
      });
      std::ranges::move(Joined({from, to}), std::back_inserter(faces));
      from = to;
    }
    pieces.clear();
  }
  return faces;
}

// Returns the smallest value of dot(direction, p) over all points p of the shape.
double LowestAlong(const PlacedShape& placed, const Vector2d& direction) {
  const Vector3d d(direction.x(), direction.y(), 0);
  return d.dot(placed.X_WG.p) -
         model::Support(placed.shape, Vector3d(placed.X_WG.q.conjugate() * Vector3d(-d)));
}

// Returns true if, seen from above, one edge of the polygon separates the polygon from the shape.
// The shape may touch the polygon.
bool IsBeside(const PlacedShape& placed, const Polygon& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2d normal = solid::OutwardNormal(corners, i);
    if (LowestAlong(placed, normal) >= normal.dot(corners[i]) - kTouching) return true;
  }
  return false;
}

// Removes the area of the face below the shape by a cut parallel to one of the edges. The cut that
// keeps the largest area is used.
void CutOff(const PlacedShape& placed, LevelFace& face) {
  if (IsBeside(placed, face.corners)) return;
  MakePolygon(face);
  Polygon best;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Vector2d normal = solid::OutwardNormal(face.corners, i);
    Polygon rest = Simplified(solid::Clipped(face.corners, normal, LowestAlong(placed, normal)));
    if (solid::AreaOf(rest) > solid::AreaOf(best)) best = std::move(rest);
  }
  face.corners = std::move(best);
}

// Reduces the face to an area above which at least `height` is free, and sets the face's free
// height. Stops if less than `area` remains.
void CutBack(std::span<const PlacedShape> shapes, double height, double area, LevelFace& face) {
  for (const PlacedShape& placed : shapes) {
    const double low = placed.box.min.z() - face.z;
    if (placed.box.max.z() <= face.z + kTouching || low >= height) continue;
    CutOff(placed, face);
    if (AreaOfFace(face) < area) return;
  }
  for (const PlacedShape& placed : shapes) {
    const double low = placed.box.min.z() - face.z;
    if (low < height || low >= face.height || IsBeside(placed, face.corners)) continue;
    face.height = low;
  }
}

// Sorts the faces by decreasing area, and faces of equal area by decreasing height.
void SortBySize(std::vector<LevelFace>& faces) {
  std::ranges::stable_sort(faces, {}, [](const LevelFace& face) {
    return std::tuple(-std::llround(AreaOfFace(face) * 1e9), -std::llround(face.z * 1e9));
  });
}

}  // namespace

double AreaOfFace(const LevelFace& face) {
  return face.radius ? std::numbers::pi * *face.radius * *face.radius : solid::AreaOf(face.corners);
}

std::vector<LevelFace> FindLevelFaces(std::span<const PlacedShape> own,
                                      std::span<const PlacedShape> all, double area,
                                      double height) {
  std::vector<LevelFace> faces = TopFaces(own);
  const auto is_small = [area](const LevelFace& face) { return AreaOfFace(face) < area; };
  std::erase_if(faces, is_small);
  SortBySize(faces);
  if (faces.size() > kMostFaces) faces.resize(kMostFaces);
  for (LevelFace& face : faces) CutBack(all, height, area, face);
  std::erase_if(faces, is_small);
  SortBySize(faces);
  return faces;
}

}  // namespace mjforge::assemble
