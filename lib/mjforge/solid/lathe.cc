#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mjforge/solid/convex.h"
#include "mjforge/solid/look.h"
#include "mjforge/solid/moments.h"
#include "mjforge/solid/wedges.h"

namespace mjforge::solid {
namespace {

// Of the size of the profile: what is nearer to the axis is on it, as where an arc ends there.
constexpr double kOnAxis = 1e-9;

std::optional<std::vector<Point>> SnappedToAxis(std::vector<Point> profile, Fault& fault) {
  double size = 0;
  for (const Point& p : profile) size = std::max(size, p.cwiseAbs().maxCoeff());
  for (std::size_t i = 0; i < profile.size(); ++i) {
    double& r = profile[i].x();
    if (std::abs(r) <= kOnAxis * size) r = 0;
    if (r >= 0) continue;
    fault = {fmt::format("is beyond the axis: r is {:g} m", r), i};
    return std::nullopt;
  }
  return profile;
}

// There the solid would be held together by a point.
bool TouchesAxis(const Outline& outline, Fault& fault) {
  const std::vector<Point>& p = outline.corners;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i].x() != 0) continue;
    if (p[outline.Next(i)].x() == 0 || p[outline.Previous(i)].x() == 0) continue;
    fault = {"touches the axis without following it", outline.sources[i]};
    return true;
  }
  return false;
}

}  // namespace

std::optional<Solid> Make(const Lathe& lathe, Fault& fault) {
  const std::optional<std::vector<Point>> profile = SnappedToAxis(lathe.profile, fault);
  if (!profile) return std::nullopt;
  const std::optional<Outline> outline =
      lathe.wall ? WalledOutline(*profile, *lathe.wall, fault) : OutlineOf(*profile, fault);
  if (!outline || TouchesAxis(*outline, fault)) return std::nullopt;
  const Partition partition = PartitionOf(Area(outline->corners));
  Solid solid;
  solid.look = Make(TurnedLook{.outline = *outline,
                               .partition = partition,
                               .line = *profile,
                               .is_closed = !lathe.wall,
                               .angle = lathe.angle,
                               .crease = lathe.crease,
                               .texture = lathe.texture});
  solid.pieces = TurnedPieces(*outline, partition, lathe.angle, lathe.facets);
  solid.mass = TurnedMass(NodesOf(outline->corners), lathe.angle);
  return solid;
}

}  // namespace mjforge::solid
