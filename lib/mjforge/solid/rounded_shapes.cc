// Convex hulls, boxes and cylinders with rounded edges.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/solid/lathe_pieces.h"
#include "mjforge/solid/moments.h"
#include "mjforge/solid/polytope.h"
#include "mjforge/solid/render_mesh.h"

namespace mjforge::solid {
namespace {

constexpr int kPieceSegments = 8;  // segments of a piece's edge in a whole turn

bool IsTooRound(double round, double least, Fault& fault) {
  fault = {};
  if (round < least) return false;
  fault.message = fmt::format(
      "is rounded with {:g} m, no less than its smallest half size of {:g} m", round, least);
  return true;
}

/// Returns a mesh with flat shading: each face has its own vertices.
TriangleMesh FlatMesh(const Polytope& polytope) {
  TriangleMesh mesh;
  for (const Polytope::Face& face : polytope.faces) {
    const int first = static_cast<int>(mesh.vertices.size());
    const int count = static_cast<int>(face.corners.size());
    for (const int corner : face.corners) {
      mesh.vertices.push_back(polytope.vertices[static_cast<std::size_t>(corner)]);
      mesh.normals.push_back(face.normal);
    }
    for (int i = 1; i + 1 < count; ++i) mesh.triangles.push_back({first, first + i, first + i + 1});
  }
  return mesh;
}

/// Returns the Minkowski sum of a core, which may be flat, and a ball of the radius `round`, m.
Solid Rounded(const Polytope& core, double round, const TextureMapping& texture,
              bool is_flat = false) {
  const Eigen::AlignedBox3d box = BoxAround(core.vertices);
  // Allows a larger chord error, because the triangles at a corner grow with the square of the
  // segments of an edge.
  const double error = ChordError(box.sizes().maxCoeff() / 2 + round, 0.02);
  Solid solid;
  solid.render_mesh = RoundedMesh(core, round, SegmentsPerTurn(round, error, kWholeTurn));
  if (is_flat) RemoveRepeats(solid.render_mesh);
  ProjectTextureFromAbove(texture, solid.render_mesh);
  RoundCoordinates(solid.render_mesh);
  solid.pieces.push_back({.mesh = RoundedMesh(core, round, kPieceSegments)});
  if (is_flat) RemoveRepeats(solid.pieces[0].mesh);
  solid.pieces[0].mesh.normals.clear();
  solid.mass = RoundedMass(core, round);
  solid.extent = ExtentOf(core.vertices, round);
  return solid;
}

/// Returns the Minkowski sum of a ball and the hull of points in a plane (a rounded slab), on a
/// line (a capsule) or at one place (a ball).
Solid RoundedFlat(const ConvexHull& hull) {
  const FlatHull flat = FlatHullOf(hull.points);
  Solid solid = Rounded(flat.core, hull.round, hull.texture, true);
  if (!flat.line) return solid;
  const auto& [from, to] = *flat.line;
  const auto type = from == to ? ConvexPiece::Type::kSphere : ConvexPiece::Type::kCapsule;
  solid.pieces = {Primitive(type, {hull.round, (to - from).norm() / 2, 0}, from, to)};
  return solid;
}

}  // namespace

std::optional<Solid> Make(const ConvexHull& hull, Fault& fault) {
  if (hull.points.size() > kMostPoints) return Fail(fault, "has more than 1000 points");
  const std::optional<Polytope> core = HullOf(hull.points, fault);
  if (!core && hull.round > 0 && !hull.points.empty()) return RoundedFlat(hull);
  if (!core) return std::nullopt;
  if (hull.round > 0) return Rounded(*core, hull.round, hull.texture);
  Solid solid;
  if (hull.texture.unit == TextureMapping::Unit::kNone) {
    solid.pieces.push_back({.mesh = MeshOf(*core)});
  } else {
    solid.render_mesh = FlatMesh(*core);
    ProjectTextureFromAbove(hull.texture, solid.render_mesh);
  }
  solid.mass = RoundedMass(*core, 0);
  return solid;
}

std::optional<Solid> Make(const RoundedBox& box, Fault& fault) {
  if (IsTooRound(box.round, box.half.minCoeff(), fault)) return std::nullopt;
  Solid solid = Rounded(BoxOf(box.half.array() - box.round), box.round, box.texture);
  if (box.piece_is_plain) solid.pieces = {{.type = ConvexPiece::Type::kBox, .size = box.half}};
  return solid;
}

std::optional<Solid> Make(const RoundedCylinder& cylinder, Fault& fault) {
  const double r = cylinder.radius;
  const double h = cylinder.half;
  if (IsTooRound(cylinder.round, std::min(r, h), fault)) return std::nullopt;
  Outline section;
  for (const Point2& p : {Point2(0, -h), Point2(r, -h), Point2(r, h), Point2(0, h)})
    section.Add(p, section.corners.size());
  const auto corners = RoundCorners(section, {0, cylinder.round, cylinder.round, 0}, 0, fault);
  if (!corners) return std::nullopt;
  const auto section_with = [&](int per_turn) {
    Outline outline;
    for (const Point2& p : PointsOf(*corners, per_turn, false))
      outline.Add(p, outline.corners.size());
    return outline;
  };
  const double error = ChordError(std::max(r, h));
  const Outline fine = section_with(SegmentsPerTurn(cylinder.round, error, kWholeTurn));
  const Lathe lathe = {.profile = fine.corners,
                       .facets = cylinder.facets,
                       .crease = cylinder.crease,
                       .texture = cylinder.texture};
  Solid solid;
  solid.render_mesh = MakeLatheMesh(lathe, fine, PartitionOf(Area(fine.corners)));
  if (cylinder.piece_is_plain) {
    solid.pieces = {{.type = ConvexPiece::Type::kCylinder, .size = {r, h, 0}}};
  } else {
    const Outline coarse = section_with(kPieceSegments);
    solid.pieces = MakeLathePieces(lathe, coarse, PartitionOf(Area(coarse.corners)));
  }
  solid.mass = RevolvedMass(NodesOf(*corners, DirectionsOf(*corners)), kWholeTurn);
  for (const double z : {cylinder.round - h, h - cylinder.round}) {
    AddLevelArc({0, 0, z}, r - cylinder.round, 0, kWholeTurn, solid.extent);
    solid.extent.back().round = cylinder.round;
  }
  return solid;
}

}  // namespace mjforge::solid
