// Parts of shapes that MuJoCo does not have: what is seen, the pieces that collide, the mass.

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "mjforge/model/assets.h"

namespace mjforge::model {
namespace {

using diag::Code;
using spec::Key;

constexpr std::size_t kManyPieces = 100;

using SharedSolid = std::shared_ptr<const solid::Solid>;

// MuJoCo makes a convex prism's look of the piece itself, but without texture coordinates.
SharedSolid PlainPrism(const solid::Prism& prism) {
  if (!prism.holes.empty() || prism.round > 0 || prism.bevel > 0) return nullptr;
  std::vector<double> corners;
  for (const Eigen::Vector2d& p : prism.polygon) corners.insert(corners.end(), {p.x(), p.y()});
  std::string why_not;
  std::optional<TriangleMesh> mesh = MakePrism(corners, prism.height, why_not);
  if (!mesh) return nullptr;
  solid::Solid plain;
  plain.pieces.push_back(
      {.vertices = std::move(mesh->vertices), .triangles = std::move(mesh->triangles)});
  return std::make_shared<const solid::Solid>(std::move(plain));
}

SharedSolid SolidOf(const solid::SolidShape& shape, solid::Cache& solids, solid::Fault& fault) {
  if (const auto* prism = std::get_if<solid::Prism>(&shape)) {
    if (SharedSolid plain = PlainPrism(*prism)) {
      const bool has_texture = prism->texture.unit != solid::TextureMapping::Unit::kNone;
      SharedSolid whole = has_texture ? solids.Make(shape, fault) : nullptr;
      return whole ? whole : plain;
    }
  }
  return solids.Make(shape, fault);
}

GeomType TypeOf(solid::ConvexPiece::Type type) {
  switch (type) {
    case solid::ConvexPiece::Type::kSphere:
      return GeomType::kSphere;
    case solid::ConvexPiece::Type::kCapsule:
      return GeomType::kCapsule;
    case solid::ConvexPiece::Type::kCylinder:
      return GeomType::kCylinder;
    case solid::ConvexPiece::Type::kBox:
      return GeomType::kBox;
    case solid::ConvexPiece::Type::kMesh:
      break;
  }
  return GeomType::kMesh;
}

MassProperties PropertiesOf(const solid::Mass& mass) {
  return {.mass = mass.volume, .p_FCm = mass.center, .I_Cm_F = mass.inertia};
}

}  // namespace

void Assets::AddLook(const TriangleMesh& look, Part& part) {
  AddInline({.vertices = look.vertices,
             .triangles = look.triangles,
             .normals = look.normals,
             .texcoords = look.texcoords,
             .in_micrometres = look.in_micrometres},
            part);
}

void Assets::SetPieceShape(const solid::ConvexPiece& piece, Part& part) {
  if (piece.type == solid::ConvexPiece::Type::kMesh) {
    AddInline({.vertices = piece.vertices, .triangles = piece.triangles}, part);
  } else {
    part.shape = {.type = TypeOf(piece.type), .size = piece.size};
    part.X_BG = {piece.p, piece.q};
  }
}

std::vector<Part> Assets::AddSolid(const solid::Solid& solid, Part& part) {
  if (solid.pieces.empty()) {
    AddLook(solid.look, part);
    return {};
  }
  // A convex solid of one mesh is one geom, as MuJoCo's own are.
  if (solid.look.vertices.empty()) {
    SetPieceShape(solid.pieces.back(), part);
    return {};
  }
  part.solid = PropertiesOf(solid.mass);
  if (part.role != Role::kCollision) AddLook(solid.look, part);
  if (part.role == Role::kVisual) return {};
  std::vector<Part> pieces;
  for (const solid::ConvexPiece& made : solid.pieces) {
    Part piece;
    piece.piece_of = part.name;
    piece.mark = part.mark;
    piece.name = fmt::format("{}_{}", part.name, pieces.size());
    SetPieceShape(made, piece);
    const bool is_mesh = made.type == solid::ConvexPiece::Type::kMesh;
    for (const double turn : made.turns) {
      piece.name = fmt::format("{}_{}", part.name, pieces.size());
      if (is_mesh)
        piece.X_BG.q = Eigen::Quaterniond(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()));
      pieces.push_back(piece);
    }
  }
  return pieces;
}

void Assets::Report(const FieldReader& reader, const SolidInput& input, const solid::Fault& fault) {
  // "hole 2 of part 'lid'", "profile of part 'mug': point 3", "part 'pin'".
  std::string where = reader.Owner();
  diag::SourceMark mark = input.field.value.mark;
  const auto& marks = input.marks;
  const bool has_marks = fault.loop < marks.size() && !marks[fault.loop].empty();
  if (fault.loop > 0) {
    where = fmt::format("hole {} of {}", fault.loop, where);
  } else if (fault.point) {
    where = fmt::format("{} of {}", input.field.info->key, where);
  }
  if (fault.point) where += fmt::format(": point {}", *fault.point + 1);
  if (has_marks && (fault.loop > 0 || fault.point))
    mark = marks[fault.loop][fault.point.value_or(0)];
  findings_.Add(Code::kModelBadShape, mark, fmt::format("{} {}", where, fault.message));
}

std::optional<std::vector<Part>> Assets::AddShape(const FieldReader& reader,
                                                  const SolidInput& input, Part& part) {
  solid::Fault fault;
  const SharedSolid solid = SolidOf(input.shape, assembler_.solids(), fault);
  if (solid == nullptr) {
    Report(reader, input, fault);
    return std::nullopt;
  }
  std::vector<Part> pieces = AddSolid(*solid, part);
  if (pieces.size() > kManyPieces) {
    findings_.Warn(Code::kModelBadShape, input.field.value.mark,
                   fmt::format("{} collides as {} pieces, more than {}", reader.Owner(),
                               pieces.size(), kManyPieces),
                   "fewer points where it is hollow, or fewer `facets`");
  }
  return pieces;
}

}  // namespace mjforge::model
