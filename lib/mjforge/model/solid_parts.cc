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
      {.mesh = {.vertices = std::move(mesh->vertices), .triangles = std::move(mesh->triangles)}});
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

// A piece that is not a mesh.
struct Primitive {
  GeomType type;
  Eigen::Vector3d size;
  Eigen::Vector3d p;
  Eigen::Quaterniond q;
};

// A solid as its parts need it; what a tape's step fills again.
struct Made {
  std::vector<TriangleMesh> meshes;  // what is seen, then each piece; of a primitive an empty one
  std::vector<std::vector<double>> turns;  // rad, of each piece
  std::vector<Primitive> primitives;
  solid::Mass mass;
};

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

Made MadeOf(const solid::Solid& solid) {
  const solid::TriangleMesh& look = solid.render_mesh;
  Made made;
  made.mass = solid.mass;
  made.meshes.push_back({.vertices = look.vertices,
                         .triangles = look.triangles,
                         .normals = look.normals,
                         .texcoords = look.texcoords,
                         .in_micrometres = look.in_micrometres});
  for (const solid::ConvexPiece& piece : solid.pieces) {
    made.meshes.push_back({.vertices = piece.mesh.vertices, .triangles = piece.mesh.triangles});
    made.turns.push_back(piece.turns);
    if (piece.type != solid::ConvexPiece::Type::kMesh)
      made.primitives.push_back({TypeOf(piece.type), piece.size, piece.p, piece.q});
  }
  return made;
}

// Into the same memory, whose places are known; false if there are more or fewer.
template <typename T>
bool Copy(const std::vector<T>& from, std::vector<T>& to) {
  if (from.size() != to.size()) return false;
  std::ranges::copy(from, to.begin());
  return true;
}

// Gives `to` the numbers of another solid; false if that has others.
bool Refill(const solid::Solid& from, Made& to) {
  const solid::TriangleMesh& look = from.render_mesh;
  TriangleMesh& seen = to.meshes.front();
  if (look.triangles != seen.triangles || look.in_micrometres != seen.in_micrometres ||
      from.pieces.size() != to.turns.size() || !Copy(look.vertices, seen.vertices) ||
      !Copy(look.normals, seen.normals) || !Copy(look.texcoords, seen.texcoords))
    return false;
  auto primitive = to.primitives.begin();
  for (std::size_t i = 0; i < from.pieces.size(); ++i) {
    const solid::ConvexPiece& piece = from.pieces[i];
    TriangleMesh& mesh = to.meshes[i + 1];
    if (piece.mesh.triangles != mesh.triangles || !Copy(piece.mesh.vertices, mesh.vertices) ||
        !Copy(piece.turns, to.turns[i]))
      return false;
    if (piece.type == solid::ConvexPiece::Type::kMesh) continue;
    if (primitive == to.primitives.end() || primitive->type != TypeOf(piece.type)) return false;
    *primitive++ = {TypeOf(piece.type), piece.size, piece.p, piece.q};
  }
  to.mass = from.mass;
  return primitive == to.primitives.end();
}

Pose TurnAboutZ(const Traced<double>& turn) {
  const auto rotation = [](double angle) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
  };
  return {Eigen::Vector3d(Eigen::Vector3d::Zero()), tape::Apply(rotation, turn)};
}

MassProperties PropertiesOf(const Traced<solid::Mass>& mass) {
  return {.mass = tape::Member(mass, &solid::Mass::volume),
          .p_FCm = tape::Member(mass, &solid::Mass::center),
          .I_Cm_F = tape::Member(mass, &solid::Mass::inertia)};
}

// Notes a step that makes the solid again. Returns where it leaves it.
Made& OnTape(tape::Tape& tape, const SolidInput& input, solid::Cache& solids, Made& made) {
  for (TriangleMesh& mesh : made.meshes) mesh.tape = &tape;
  Made& at = tape.Keep(made);
  std::vector<const double*> places;
  for (const Traced<double>& number : input.numbers) places.push_back(&PlaceOf(tape, number));
  tape.Add([&at, &solids, shape_of = input.shape_of, places = tape.KeepAll(places)] {
    std::vector<double> numbers;
    for (const double* place : places) numbers.push_back(*place);
    solid::Fault fault;
    const SharedSolid again = SolidOf(shape_of(numbers), solids, fault);
    return again != nullptr && Refill(*again, at);
  });
  return at;
}

tape::Tape* TapeOf(const SolidInput& input) {
  for (const Traced<double>& number : input.numbers) {
    if (number.tape() != nullptr) return number.tape();
  }
  return nullptr;
}

/// What the tape, if there is one, leaves at a place.
template <typename T>
Traced<T> On(tape::Tape* tape, const T& value, const T& place) {
  return tape != nullptr ? Traced<T>(value, *tape, place) : Traced<T>(value);
}

void Place(const Primitive& made, const Primitive& at, tape::Tape* tape, Part& piece) {
  piece.shape = {.type = made.type, .size = On(tape, made.size, at.size)};
  piece.X_BG = {On(tape, made.p, at.p), On(tape, made.q, at.q)};
}

}  // namespace

std::vector<Part> Assets::AddSolid(const SolidInput& input, const solid::Solid& solid, Part& part) {
  Made made = MadeOf(solid);
  tape::Tape* const tape = TapeOf(input);
  const Made& at = tape != nullptr ? OnTape(*tape, input, assembler_.solids(), made) : made;
  const auto add_mesh = [&](std::size_t mesh, Part& to) {
    AddInline(made.meshes[mesh], tape != nullptr ? &at.meshes[mesh] : nullptr, to);
  };
  // A convex solid of one mesh is one geom, as MuJoCo's own are.
  if (solid.pieces.empty() || made.meshes[0].vertices.empty()) {
    add_mesh(solid.pieces.size(), part);
    return {};
  }
  part.solid = PropertiesOf(On(tape, made.mass, at.mass));
  if (part.role != Role::kCollision) add_mesh(0, part);
  if (part.role == Role::kVisual) return {};
  std::vector<Part> pieces;
  tape::Tape* const turns_tape = input.turns_vary ? tape : nullptr;
  std::size_t primitive = 0;
  for (std::size_t i = 0; i < made.turns.size(); ++i) {
    Part piece;
    piece.piece_of = part.name;
    piece.mark = part.mark;
    const bool is_mesh = !made.meshes[i + 1].vertices.empty();
    for (std::size_t k = 0; k < made.turns[i].size(); ++k) {
      piece.name = fmt::format("{}_{}", part.name, pieces.size());
      if (is_mesh && k == 0) add_mesh(i + 1, piece);
      if (is_mesh) {
        piece.X_BG = TurnAboutZ(On(turns_tape, made.turns[i][k], at.turns[i][k]));
      } else {
        Place(made.primitives[primitive], at.primitives[primitive], tape, piece);
        ++primitive;
      }
      pieces.push_back(piece);
    }
  }
  return pieces;
}

void Assets::Report(const FieldReader& reader, const spec::Field& field, const SolidInput& input,
                    const solid::Fault& fault) {
  // "hole 2 of part 'lid'", "profile of part 'mug': point 3", "part 'pin'".
  std::string where = reader.Owner();
  diag::SourceMark mark = field.value.mark;
  const auto& marks = input.marks;
  const bool has_marks = fault.loop < marks.size() && !marks[fault.loop].empty();
  if (fault.loop > 0) {
    where = fmt::format("hole {} of {}", fault.loop, where);
  } else if (fault.point) {
    where = fmt::format("{} of {}", field.info->key, where);
  }
  if (fault.point) where += fmt::format(": point {}", *fault.point + 1);
  if (has_marks && (fault.loop > 0 || fault.point))
    mark = marks[fault.loop][fault.point.value_or(0)];
  findings_.Add(Code::kModelBadShape, mark, fmt::format("{} {}", where, fault.message));
}

std::optional<std::vector<Part>> Assets::AddShape(FieldReader& reader, const spec::Field& field,
                                                  const SolidInput& input, Part& part) {
  const std::vector<double> numbers(input.numbers.begin(), input.numbers.end());
  solid::Fault fault;
  const SharedSolid solid = SolidOf(input.shape_of(numbers), assembler_.solids(), fault);
  if (solid == nullptr) {
    Report(reader, field, input, fault);
    return std::nullopt;
  }
  std::vector<Part> pieces = AddSolid(input, *solid, part);
  if (pieces.size() > kManyPieces) {
    findings_.Warn(Code::kModelBadShape, field.value.mark,
                   fmt::format("{} collides as {} pieces, more than {}", reader.Owner(),
                               pieces.size(), kManyPieces),
                   "fewer points where it is hollow, or fewer `facets`");
  }
  return pieces;
}

}  // namespace mjforge::model
