#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "mjforge/model/meshes.h"

namespace mjforge::model {
namespace {

using Corner = Eigen::Vector2d;

double Cross(const Corner& a, const Corner& b) { return a.x() * b.y() - a.y() * b.x(); }

// Counter-clockwise, without repeats and corners on a straight line; `numbers`
// counts the corners that stay as the user does, from 1.
struct Outline {
  std::vector<Corner> corners;
  std::vector<std::size_t> numbers;
};

Outline WithoutRepeats(std::span<const double> polygon) {
  Outline outline;
  const std::size_t count = polygon.size() / 2;
  for (std::size_t i = 0; i < count; ++i) {
    const Corner corner(polygon[2 * i], polygon[2 * i + 1]);
    if (!outline.corners.empty() && corner == outline.corners.back()) continue;
    outline.corners.push_back(corner);
    outline.numbers.push_back(i + 1);
  }
  while (outline.corners.size() > 1 && outline.corners.front() == outline.corners.back()) {
    outline.corners.pop_back();
    outline.numbers.pop_back();
  }
  return outline;
}

double SignedArea(const std::vector<Corner>& corners) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    twice += Cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return twice / 2;
}

// Turns smaller than this sine are rounding, not corners.
constexpr double kStraight = 1e-12;

// The first corner that turns against `direction` (+1 or -1) or reverses, or 0;
// corners that do not turn are taken out. A convex outline turns one way and by
// one whole turn altogether; a star turns one way but several times round.
std::size_t TakeOutStraightCorners(Outline& outline, double direction) {
  Outline kept;
  double turned = 0;
  const std::size_t count = outline.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Corner in = outline.corners[i] - outline.corners[(i + count - 1) % count];
    const Corner out = outline.corners[(i + 1) % count] - outline.corners[i];
    const double sine = direction * Cross(in, out) / (in.norm() * out.norm());
    const double cosine = in.dot(out);
    if (sine < -kStraight || (std::abs(sine) <= kStraight && cosine < 0)) {
      return outline.numbers[i];
    }
    turned += std::atan2(direction * Cross(in, out), cosine);
    if (turned > 2 * M_PI + 1e-6) return outline.numbers[i];
    if (sine <= kStraight) continue;
    kept.corners.push_back(outline.corners[i]);
    kept.numbers.push_back(outline.numbers[i]);
  }
  outline = std::move(kept);
  return 0;
}

TriangleMesh Extrude(const std::vector<Corner>& corners, double height) {
  TriangleMesh mesh;
  const int count = static_cast<int>(corners.size());
  mesh.vertices.reserve(2 * corners.size());
  mesh.triangles.reserve(4 * corners.size() - 4);
  for (const double z : {-height / 2, height / 2}) {
    for (const Corner& corner : corners) mesh.vertices.emplace_back(corner.x(), corner.y(), z);
  }
  for (int i = 1; i + 1 < count; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({count, count + i, count + i + 1});
  }
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    mesh.triangles.push_back({i, next, count + next});
    mesh.triangles.push_back({i, count + next, count + i});
  }
  return mesh;
}

}  // namespace

std::optional<TriangleMesh> MakePrism(std::span<const double> polygon, double height,
                                      std::string& why_not) {
  Outline outline = WithoutRepeats(polygon);
  if (outline.corners.size() < 3) {
    why_not = "polygon needs at least 3 corners";
    return std::nullopt;
  }
  double size = 0;
  for (const Corner& corner : outline.corners) {
    size = std::max(size, (corner - outline.corners[0]).squaredNorm());
  }
  const double area = SignedArea(outline.corners);
  if (!(std::abs(area) > kStraight * size)) {
    why_not = "polygon has no area";
    return std::nullopt;
  }
  if (const std::size_t corner = TakeOutStraightCorners(outline, area > 0 ? 1 : -1)) {
    why_not = fmt::format("polygon is not convex at corner {}", corner);
    return std::nullopt;
  }
  if (area < 0) std::reverse(outline.corners.begin(), outline.corners.end());
  return Extrude(outline.corners, height);
}

}  // namespace mjforge::model
