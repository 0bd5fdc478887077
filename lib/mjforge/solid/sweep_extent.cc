// Extent of a tube: curves whose convex hull is the convex hull of the tube.

#include <cmath>

#include "mjforge/solid/sweep_frames.h"
#include "mjforge/solid/sweep_mesh.h"

namespace mjforge::solid {
namespace {

using Eigen::Vector3d;

constexpr int kArcsPerCubic = 16;

/// Returns the ellipse in which a plane cuts the tube at a frame.
ExtentCurve CutOf(const SweepFrame& frame) {
  const auto on_cut = [&frame](const Vector3d& across) {
    return Vector3d(across - across.dot(frame.cut) / frame.tangent.dot(frame.cut) * frame.tangent);
  };
  // The axes of the ellipse are along and across the plane's slope.
  const Vector3d slope = frame.cut - frame.cut.dot(frame.tangent) * frame.tangent;
  const Vector3d x = slope.norm() > 1e-9 ? Vector3d(slope.normalized()) : frame.x;
  return {.center = frame.p,
          .u = frame.radius * on_cut(x),
          .v = frame.radius * on_cut(frame.tangent.cross(x))};
}

/// Adds the arc through three points, unless they are on a line.
void AddArc(const Vector3d& a, const Vector3d& middle, const Vector3d& b, double round,
            Extent& extent) {
  const Vector3d in = a - middle;
  const Vector3d out = b - middle;
  const Vector3d normal = in.cross(out);
  if (normal.norm() <= 1e-9 * in.norm() * out.norm()) return;
  const Vector3d center = middle + (in.squaredNorm() * out - out.squaredNorm() * in).cross(normal) /
                                       (2 * normal.squaredNorm());
  const Vector3d u = a - center;
  const Vector3d v = u.cross(normal.normalized());
  const Vector3d end = b - center;
  const double angle = std::atan2(v.dot(end), u.dot(end));
  extent.push_back({.center = center, .u = u, .v = v, .angle = angle, .round = round});
}

}  // namespace

Extent SweepExtentOf(const std::vector<PathSegment>& segments, bool closed) {
  using Type = PathSegment::Type;
  Extent extent;
  const bool has_cubics = segments.front().type == Type::kCubic;
  for (const SweepFrame& frame :
       SweepFramesOf(segments, closed, has_cubics ? 4 * kArcsPerCubic : 1))
    extent.push_back(CutOf(frame));
  for (const PathSegment& segment : segments) {
    if (segment.type == Type::kArc)
      extent.push_back({segment.a, segment.da, segment.db, segment.angle, segment.radius_a});
    for (int i = 0; segment.type == Type::kCubic && i < kArcsPerCubic; ++i) {
      const auto at = [&](double t) { return segment.At((i + t) / kArcsPerCubic); };
      AddArc(at(0), at(0.5), at(1), segment.RadiusAt((i + 0.5) / kArcsPerCubic), extent);
    }
  }
  return extent;
}

}  // namespace mjforge::solid
