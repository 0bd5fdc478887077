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

/// How far each point is along the profile, m, and behind the last the whole way round.
std::vector<double> Lengths(const std::vector<Point>& profile, bool closed) {
  std::vector<double> lengths = {0};
  const std::size_t count = profile.size();
  for (std::size_t i = 1; i < count + (closed ? 1 : 0); ++i)
    lengths.push_back(lengths.back() + (profile[i % count] - profile[i - 1]).norm());
  if (!closed) lengths.push_back(lengths.back());
  return lengths;
}

/// Makes texture coordinates of the lengths along; returns that of a whole turn.
double LayOn(const Texture& texture, const std::vector<Point>& profile,
             std::vector<double>& along) {
  // A picture's rows are counted from its top.
  const double length = along.back();
  double radius = 0;
  for (const Point& p : profile) radius = std::max(radius, p.x());
  const bool by_metre = texture.unit == Texture::Unit::kMetre;
  const double scale = texture.repeat.y() / (by_metre ? 1 : length);
  for (double& number : along) number = (length - number) * scale;
  return texture.repeat.x() * (by_metre ? 2 * std::numbers::pi * radius : 1);
}

}  // namespace

std::optional<Solid> Make(const Lathe& lathe, Fault& fault) {
  const std::optional<std::vector<Point>> profile = SnappedToAxis(lathe.profile, fault);
  if (!profile) return std::nullopt;
  const std::optional<Outline> outline =
      lathe.wall ? WalledOutline(*profile, *lathe.wall, fault) : OutlineOf(*profile, fault);
  if (!outline || TouchesAxis(*outline, fault)) return std::nullopt;
  const Partition partition = PartitionOf(*outline);
  std::vector<double> along = Lengths(*profile, !lathe.wall);
  const double around = LayOn(lathe.texture, *profile, along);
  Solid solid;
  solid.look = Make(TurnedLook{*outline, partition, along, lathe.angle, lathe.crease, around});
  if (lathe.texture.unit == Texture::Unit::kNone) solid.look.texcoords.clear();
  RoundForText(solid.look);
  solid.pieces = TurnedPieces(*outline, partition, lathe.angle, lathe.facets);
  solid.mass = TurnedMass(outline->corners, lathe.angle);
  return solid;
}

}  // namespace mjforge::solid
