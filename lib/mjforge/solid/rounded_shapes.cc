#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/solid/look.h"
#include "mjforge/solid/moments.h"
#include "mjforge/solid/polytope.h"
#include "mjforge/solid/wedges.h"

namespace mjforge::solid {
namespace {

// Segments of a round edge in a whole turn: of what is seen, of what collides.
constexpr int kSeen = 16;
constexpr int kCollides = 8;

bool IsTooRound(double round, double least, Fault& fault) {
  fault = {};
  if (round < least) return false;
  fault.message = fmt::format(
      "is rounded with {:g} m, no less than its smallest half size of {:g} m", round, least);
  return true;
}

Solid Rounded(const Polytope& core, double round) {
  Solid solid;
  solid.look = RoundedSurface(core, round, kSeen);
  RoundForText(solid.look);
  Surface coarse = RoundedSurface(core, round, kCollides);
  solid.pieces.push_back(
      {.vertices = std::move(coarse.vertices), .triangles = std::move(coarse.triangles)});
  solid.mass = RoundedMass(core, round);
  return solid;
}

Piece PlainPiece(Piece::Type type, const Eigen::Vector3d& size) {
  return {.type = type, .size = size};
}

}  // namespace

std::optional<Solid> Make(const Hull& hull, Fault& fault) {
  const std::optional<Polytope> core = HullOf(hull.points, fault);
  if (!core) return std::nullopt;
  if (hull.round > 0) return Rounded(*core, hull.round);
  Solid solid;
  solid.pieces.push_back(PieceOf(*core));
  solid.mass = RoundedMass(*core, 0);
  return solid;
}

std::optional<Solid> Make(const RoundedBox& box, Fault& fault) {
  if (IsTooRound(box.round, box.half.minCoeff(), fault)) return std::nullopt;
  Solid solid = Rounded(BoxOf(box.half.array() - box.round), box.round);
  if (box.piece_is_plain) solid.pieces = {PlainPiece(Piece::Type::kBox, box.half)};
  return solid;
}

std::optional<Solid> Make(const RoundedCylinder& cylinder, Fault& fault) {
  const double r = cylinder.radius;
  const double h = cylinder.half;
  if (IsTooRound(cylinder.round, std::min(r, h), fault)) return std::nullopt;
  Outline section;
  for (const Point& p : {Point(0, -h), Point(r, -h), Point(r, h), Point(0, h)})
    section.Add(p, section.corners.size());
  const auto corners = RoundedCorners(section, {0, cylinder.round, cylinder.round, 0}, 0, fault);
  if (!corners) return std::nullopt;
  const auto drawn = [&](int per_turn) {
    Outline outline;
    for (const Point& p : PointsOf(*corners, per_turn, false))
      outline.Add(p, outline.corners.size());
    return outline;
  };
  const Outline seen = drawn(kSeen);
  constexpr double kWhole = 2 * std::numbers::pi;
  Solid solid;
  solid.look = Make(TurnedLook{.outline = seen,
                               .partition = PartitionOf(Area(seen.corners)),
                               .line = seen.corners,
                               .is_closed = true,
                               .angle = kWhole,
                               .crease = cylinder.crease,
                               .texture = cylinder.texture});
  const Outline coarse = drawn(kCollides);
  solid.pieces = TurnedPieces(coarse, PartitionOf(Area(coarse.corners)), kWhole, cylinder.facets);
  if (cylinder.piece_is_plain) solid.pieces = {PlainPiece(Piece::Type::kCylinder, {r, h, 0})};
  solid.mass = TurnedMass(NodesOf(*corners), kWhole);
  return solid;
}

}  // namespace mjforge::solid
