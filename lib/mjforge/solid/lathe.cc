// Lathes: solids of revolution of a closed profile or of a wall along an open line.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mjforge/solid/lathe_pieces.h"
#include "mjforge/solid/moments.h"
#include "mjforge/solid/render_mesh.h"

namespace mjforge::solid {
namespace {

// Points up to this distance from the axis, relative to the profile's size, are moved onto the
// axis, because the end of a computed arc misses the axis by a rounding error.
constexpr double kOnAxis = 1e-9;

/// Moves points close to the axis onto the axis. Returns false and sets `fault` if a point is
/// beyond the axis.
bool SnapToAxis(std::vector<Point2>& profile, Fault& fault) {
  double size = 0;
  for (const Point2& p : profile) size = std::max(size, p.cwiseAbs().maxCoeff());
  for (std::size_t i = 0; i < profile.size(); ++i) {
    double& r = profile[i].x();
    if (std::abs(r) <= kOnAxis * size) r = 0;
    if (r >= 0) continue;
    fault = {fmt::format("is beyond the axis: r is {:g} m", r), i};
    return false;
  }
  return true;
}

/// Returns true and sets `fault` if a corner is on the axis without an edge along the axis, because
/// a single point would hold the solid together.
bool TouchesAxis(const Outline& outline, Fault& fault) {
  const std::vector<Point2>& p = outline.corners;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i].x() != 0) continue;
    if (p[outline.Next(i)].x() == 0 || p[outline.Previous(i)].x() == 0) continue;
    fault = {"touches the axis without following it", outline.sources[i]};
    return true;
  }
  return false;
}

}  // namespace

std::optional<Solid> Make(const Lathe& input, Fault& fault) {
  Lathe lathe = input;
  if (!SnapToAxis(lathe.profile, fault)) return std::nullopt;
  const std::optional<Outline> outline = lathe.wall
                                             ? WalledOutline(lathe.profile, *lathe.wall, fault)
                                             : OutlineOf(lathe.profile, fault);
  if (!outline || TouchesAxis(*outline, fault)) return std::nullopt;
  const ConvexPartition partition = PartitionOf(Area(outline->corners));
  Solid solid;
  solid.render_mesh = MakeLatheMesh(lathe, *outline, partition);
  solid.pieces = MakeLathePieces(lathe, *outline, partition);
  solid.mass = RevolvedMass(NodesOf(outline->corners), lathe.angle);
  for (const Point2& p : ConvexPolygonOf(outline->corners))
    AddLevelArc({0, 0, p.y()}, p.x(), 0, lathe.angle, solid.extent);
  return solid;
}

}  // namespace mjforge::solid
