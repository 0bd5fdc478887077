#include <algorithm>

#include <fmt/format.h>

#include "mjforge/solid/look.h"
#include "mjforge/solid/moments.h"
#include "mjforge/solid/polytope.h"
#include "mjforge/solid/wedges.h"

namespace mjforge::solid {
namespace {

constexpr int kCollides = 8;  // segments of a round edge in a whole turn

bool IsTooRound(double round, double least, Fault& fault) {
  fault = {};
  if (round < least) return false;
  fault.message = fmt::format(
      "is rounded with {:g} m, no less than its smallest half size of {:g} m", round, least);
  return true;
}

/// The faces, each with vertices of its own.
Surface FlatSurface(const Polytope& polytope) {
  Surface surface;
  for (const Polytope::Face& face : polytope.faces) {
    const int first = static_cast<int>(surface.vertices.size());
    const int count = static_cast<int>(face.corners.size());
    for (const int corner : face.corners) {
      surface.vertices.push_back(polytope.vertices[static_cast<std::size_t>(corner)]);
      surface.normals.push_back(face.normal);
    }
    for (int i = 1; i + 1 < count; ++i)
      surface.triangles.push_back({first, first + i, first + i + 1});
  }
  return surface;
}

Solid Rounded(const Polytope& core, double round, const Texture& texture) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : core.vertices) box.extend(p);
  // A corner has the square of an edge's segments.
  const double error = ChordError(box.sizes().maxCoeff() / 2 + round, 0.02);
  Solid solid;
  solid.look = RoundedSurface(core, round, SegmentsOf(round, error, kWholeTurn));
  LayFromAbove(texture, solid.look);
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
  if (hull.round > 0) return Rounded(*core, hull.round, hull.texture);
  Solid solid;
  if (hull.texture.unit == Texture::Unit::kNone) {
    solid.pieces.push_back(PieceOf(*core));
  } else {
    solid.look = FlatSurface(*core);
    LayFromAbove(hull.texture, solid.look);
  }
  solid.mass = RoundedMass(*core, 0);
  return solid;
}

std::optional<Solid> Make(const RoundedBox& box, Fault& fault) {
  if (IsTooRound(box.round, box.half.minCoeff(), fault)) return std::nullopt;
  Solid solid = Rounded(BoxOf(box.half.array() - box.round), box.round, box.texture);
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
  const Outline seen = drawn(SegmentsOf(cylinder.round, ChordError(std::max(r, h)), kWholeTurn));
  Solid solid;
  solid.look = Make(TurnedLook{.outline = seen,
                               .partition = PartitionOf(Area(seen.corners)),
                               .line = seen.corners,
                               .is_closed = true,
                               .angle = kWholeTurn,
                               .crease = cylinder.crease,
                               .texture = cylinder.texture});
  const Outline coarse = drawn(kCollides);
  solid.pieces =
      TurnedPieces(coarse, PartitionOf(Area(coarse.corners)), kWholeTurn, cylinder.facets);
  if (cylinder.piece_is_plain) solid.pieces = {PlainPiece(Piece::Type::kCylinder, {r, h, 0})};
  solid.mass = TurnedMass(NodesOf(*corners), kWholeTurn);
  return solid;
}

}  // namespace mjforge::solid
