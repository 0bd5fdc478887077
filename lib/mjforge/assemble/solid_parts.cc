// Parts whose shapes the library `solid` makes: render mesh, convex pieces and mass.

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/assets.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

constexpr std::size_t kManyPieces = 100;  // more pieces cause a warning

// Geom types in the order of solid::ConvexPiece::Type.
constexpr model::GeomType kGeomTypes[] = {model::GeomType::kMesh, model::GeomType::kSphere,
                                          model::GeomType::kCapsule, model::GeomType::kCylinder,
                                          model::GeomType::kBox};

/// Assigns the extent of the solid (curves with the same convex hull, for exact bounds) to the part
/// and to one of its pieces, and an empty extent to the other pieces. Prefers a piece whose pose
/// equals the part's pose, because inverse poses have rounding errors.
void SetExtents(const std::shared_ptr<const solid::Solid>& made, model::Part& part,
                std::vector<model::Part>& pieces) {
  if (made->extent.empty()) return;
  part.extent = {made, &made->extent};
  const auto is_at_origin = [](const model::Part& piece) {
    return piece.X_BG.p.isZero(0) && piece.X_BG.q.vec().isZero(0);
  };
  const auto at_origin = std::ranges::find_if(pieces, is_at_origin);
  const auto bearer = at_origin != pieces.end() ? at_origin : pieces.begin();
  const auto no_curves = std::make_shared<const solid::Extent>();
  for (auto piece = pieces.begin(); piece != pieces.end(); ++piece) {
    piece->extent = piece == bearer ? part.extent : no_curves;
    if (piece == bearer) piece->X_GS = piece->X_BG.Inverse();
  }
}

}  // namespace

std::vector<model::Part> Assets::AddSolid(const std::shared_ptr<const solid::Solid>& made,
                                          model::Part& part) {
  const solid::Solid& solid = *made;
  // Adds a convex solid with a single mesh as a single part, like MuJoCo's own shapes.
  if (solid.pieces.empty() || solid.render_mesh.vertices.empty()) {
    AddInline(solid.pieces.empty() ? solid.render_mesh : solid.pieces.back().mesh, part);
    return {};
  }
  part.solid = model::MassProperties{
      .mass = solid.mass.volume, .p_FCm = solid.mass.center, .I_Cm_F = solid.mass.inertia};
  if (part.role != model::Role::kCollision) AddInline(solid.render_mesh, part);
  std::vector<model::Part> pieces;
  if (part.role == model::Role::kVisual) {
    SetExtents(made, part, pieces);
    return pieces;
  }
  for (const solid::ConvexPiece& convex : solid.pieces) {
    model::Part piece;
    piece.piece_of = part.name;
    piece.mark = part.mark;
    for (const double turn : convex.turns) {
      piece.name = fmt::format("{}_{}", part.name, pieces.size());
      if (convex.type != solid::ConvexPiece::Type::kMesh) {
        piece.shape = {.type = kGeomTypes[static_cast<std::size_t>(convex.type)],
                       .size = convex.size};
        piece.X_BG = {convex.p, convex.q};
      } else {
        // All rotated copies of the piece share the mesh.
        if (piece.mesh < 0) AddInline(convex.mesh, piece);
        piece.X_BG.q = Eigen::Quaterniond(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()));
      }
      pieces.push_back(piece);
    }
  }
  SetExtents(made, part, pieces);
  return pieces;
}

void Assets::Report(const FieldReader& reader, const SolidInput& input, const solid::Fault& fault) {
  // Examples: "hole 2 along x of part 'lid'", "profile of part 'mug': point 3", "part 'pin'".
  std::string where = reader.Owner();
  diag::SourceMark mark = input.field.value.mark;
  const OutlinePlace& outline = input.outlines[fault.loop];
  if (fault.loop > 0) {
    where = fmt::format("{} of {}", outline.name, where);
  } else if (fault.point) {
    where = fmt::format("{} of {}", input.field.info->key, where);
  }
  if (fault.point) where += fmt::format(": point {}", *fault.point + 1);
  if (!outline.marks.empty() && (fault.loop > 0 || fault.point))
    mark = outline.marks[fault.point.value_or(0)];
  findings_.Add(Code::kModelBadShape, mark, fmt::format("{} {}", where, fault.message));
}

std::optional<std::vector<model::Part>> Assets::AddShape(const FieldReader& reader,
                                                         const SolidInput& input,
                                                         model::Part& part) {
  solid::Fault fault;
  const std::shared_ptr<const solid::Solid> solid = assembler_.solids().Make(input.shape, fault);
  if (solid == nullptr) {
    Report(reader, input, fault);
    return std::nullopt;
  }
  std::vector<model::Part> pieces = AddSolid(solid, part);
  if (pieces.size() > kManyPieces) {
    findings_.Warn(Code::kModelBadShape, input.field.value.mark,
                   fmt::format("{} collides as {} pieces, more than {}", reader.Owner(),
                               pieces.size(), kManyPieces),
                   "fewer points where it is hollow, or fewer `facets`");
  }
  return pieces;
}

}  // namespace mjforge::assemble
