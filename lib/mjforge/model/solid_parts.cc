// Parts of shapes that MuJoCo does not have: what is seen, the pieces that collide, the mass.

#include <algorithm>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "mjforge/model/assets.h"
#include "mjforge/solid/solid.h"

namespace mjforge::model {
namespace {

using diag::Code;
using spec::Key;

constexpr std::size_t kManyPieces = 64;

// A solid as its parts need it; what a tape's step fills again.
struct Made {
  std::vector<TriangleMesh> meshes;  // what is seen, then each piece
  std::vector<double> turns;         // rad, of all pieces
  solid::Mass mass;
};

Made MadeOf(solid::Solid solid) {
  Made made;
  made.mass = solid.mass;
  made.meshes.push_back({.vertices = std::move(solid.look.vertices),
                         .triangles = std::move(solid.look.triangles),
                         .normals = std::move(solid.look.normals),
                         .texcoords = std::move(solid.look.texcoords)});
  for (solid::Piece& piece : solid.pieces) {
    made.meshes.push_back(
        {.vertices = std::move(piece.vertices), .triangles = std::move(piece.triangles)});
    made.turns.insert(made.turns.end(), piece.turns.begin(), piece.turns.end());
  }
  return made;
}

// Moves the numbers of `from` to the places of `to`; false if there are others.
bool Refill(Made& from, Made& to) {
  const auto is_same = [](const TriangleMesh& a, const TriangleMesh& b) {
    return a.vertices.size() == b.vertices.size() && a.triangles == b.triangles;
  };
  if (from.turns.size() != to.turns.size()) return false;
  if (!std::ranges::equal(from.meshes, to.meshes, is_same)) return false;
  for (std::size_t i = 0; i < to.meshes.size(); ++i) {
    to.meshes[i].vertices.swap(from.meshes[i].vertices);
    to.meshes[i].normals.swap(from.meshes[i].normals);
    to.meshes[i].texcoords.swap(from.meshes[i].texcoords);
  }
  std::ranges::copy(from.turns, to.turns.begin());
  to.mass = from.mass;
  return true;
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
Made& OnTape(tape::Tape& tape, const SolidInput& input, Made& made) {
  for (TriangleMesh& mesh : made.meshes) mesh.tape = &tape;
  Made& at = tape.Keep(made);
  std::vector<const double*> places;
  for (const Traced<double>& number : input.numbers) places.push_back(&PlaceOf(tape, number));
  tape.Add([&at, make = input.make, places = tape.KeepAll(places)] {
    std::vector<double> numbers;
    for (const double* place : places) numbers.push_back(*place);
    solid::Fault fault;
    std::optional<solid::Solid> again = make(numbers, fault);
    if (!again) return false;
    Made other = MadeOf(*std::move(again));
    return Refill(other, at);
  });
  return at;
}

}  // namespace

std::vector<Part> Assets::AddSolid(const SolidInput& input, solid::Solid solid, Part& part) {
  std::vector<std::size_t> counts;
  for (const solid::Piece& piece : solid.pieces) counts.push_back(piece.turns.size());
  Made made = MadeOf(std::move(solid));
  tape::Tape* tape = nullptr;
  for (const Traced<double>& number : input.numbers) tape = tape ? tape : number.tape();
  Made* at = tape != nullptr ? &OnTape(*tape, input, made) : nullptr;
  const auto add = [&](std::size_t mesh, Part& to) {
    AddInline(made.meshes[mesh], at != nullptr ? &at->meshes[mesh] : nullptr, to);
  };
  part.solid = PropertiesOf(at != nullptr ? Traced<solid::Mass>(made.mass, *tape, at->mass)
                                          : Traced<solid::Mass>(made.mass));
  if (part.role != Role::kCollision) add(0, part);
  std::vector<Part> pieces;
  if (part.role == Role::kVisual) return pieces;
  std::size_t turn = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    Part piece;
    piece.piece_of = part.name;
    piece.mark = part.mark;
    for (std::size_t k = 0; k < counts[i]; ++k, ++turn) {
      piece.name = fmt::format("{}_{}", part.name, pieces.size());
      if (k == 0) add(i + 1, piece);
      piece.X_BG = TurnAboutZ(at != nullptr && input.turns_vary
                                  ? Traced<double>(made.turns[turn], *tape, at->turns[turn])
                                  : Traced<double>(made.turns[turn]));
      pieces.push_back(piece);
    }
  }
  return pieces;
}

std::optional<std::vector<Part>> Assets::ReadLathe(FieldReader& reader, const spec::Entry& entry,
                                                   const solid::Texture& texture, Part& part) {
  const spec::Field* profile = Required(reader, entry, Key::kProfile, "profile", part.mark);
  if (profile == nullptr) return std::nullopt;
  const std::optional<sample::PointList> points = reader.Points(*profile);
  bool good = points.has_value();
  const auto number = [&](Key key, double without) {
    const spec::Field* field = entry.Find(key);
    std::optional<Traced<double>> read = without;
    if (field != nullptr) read = reader.Number(*field);
    good &= read.has_value();
    return read.value_or(without);
  };
  solid::Lathe lathe;
  const bool has_wall = entry.Find(Key::kWall) != nullptr;
  const Traced<double> wall = number(Key::kWall, 0);
  const Traced<double> angle = number(Key::kAngle, lathe.angle);
  const Traced<double> crease = number(Key::kCrease, lathe.crease);
  lathe.facets = static_cast<int>(tape::Fixed(number(Key::kFacets, lathe.facets)));
  lathe.texture = texture;
  if (!good) return std::nullopt;
  SolidInput input;
  input.numbers = {wall, angle, crease};
  input.turns_vary = angle.tape() != nullptr;
  input.numbers.insert(input.numbers.end(), points->numbers.begin(), points->numbers.end());
  input.marks = points->marks;
  input.make = [lathe, has_wall](std::span<const double> numbers, solid::Fault& fault) mutable {
    if (has_wall) lathe.wall = numbers[0];
    lathe.angle = numbers[1];
    lathe.crease = numbers[2];
    lathe.profile.clear();
    for (std::size_t i = 3; i < numbers.size(); i += 2)
      lathe.profile.emplace_back(numbers[i], numbers[i + 1]);
    return solid::Make(lathe, fault);
  };
  return MakeSolid(reader, *profile, input, part);
}

std::optional<std::vector<Part>> Assets::MakeSolid(FieldReader& reader, const spec::Field& field,
                                                   const SolidInput& input, Part& part) {
  const std::vector<double> numbers(input.numbers.begin(), input.numbers.end());
  solid::Fault fault;
  std::optional<solid::Solid> solid = input.make(numbers, fault);
  if (!solid) {
    const std::string point = fault.point ? fmt::format(": point {}", *fault.point + 1) : "";
    const diag::SourceMark mark = fault.point ? input.marks[*fault.point] : field.value.mark;
    findings_.Add(
        Code::kModelBadShape, mark,
        fmt::format("{} of {}{} {}", field.info->key, reader.Owner(), point, fault.message));
    return std::nullopt;
  }
  std::vector<Part> pieces = AddSolid(input, *std::move(solid), part);
  if (pieces.size() > kManyPieces) {
    findings_.Warn(Code::kModelBadShape, field.value.mark,
                   fmt::format("{} collides as {} pieces, more than {}", reader.Owner(),
                               pieces.size(), kManyPieces),
                   "fewer points where it is hollow, or fewer `facets`");
  }
  return pieces;
}

}  // namespace mjforge::model
