// Reader of the shapes that the library `solid` makes: lathe, prism, tube, hull, rounded box and
// cylinder.

#include "mjforge/assemble/solid_reader.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace mjforge::assemble {
namespace {

using spec::Key;

std::vector<Eigen::Vector2d> PointsIn(const sample::PointList& list,
                                      const Eigen::Vector2d& scale = Eigen::Vector2d::Ones()) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i + 1 < list.numbers.size(); i += 2)
    points.emplace_back(list.numbers[i] * scale.x(), list.numbers[i + 1] * scale.y());
  return points;
}

// Returns the name of a hole for findings. Holes are numbered separately for each axis.
std::string NameOfHole(std::size_t number, std::size_t axis) {
  if (axis == 2) return fmt::format("hole {}", number);
  return fmt::format("hole {} along {}", number, axis == 0 ? "x" : "y");
}

// Reads the fields of one shape, and makes the shape if all fields are valid.
class SolidReader {
 public:
  SolidReader(FieldReader& reader, const spec::Entry& entry, diag::SourceMark mark)
      : reader_(reader), entry_(entry), mark_(mark) {}

  /// Returns the value of an optional field; `without` if the entry does not have the field.
  double Number(Key key, double without) { return Read(key, &FieldReader::Number, without); }

  int Integer(Key key, int without) { return static_cast<int>(Number(key, without)); }

  bool Flag(Key key, bool without) { return Read(key, &FieldReader::Boolean, without); }

  std::optional<double> Wall() {
    if (entry_.Find(Key::kWall) == nullptr) return std::nullopt;
    return Number(Key::kWall, 0);
  }

  /// Returns the points of a required field. Findings about the shape refer to this field.
  sample::PointList Points(Key key, std::string_view name) {
    field_ = Required(reader_, entry_, key, name, mark_);
    std::optional<sample::PointList> points =
        field_ != nullptr ? reader_.Points(*field_) : std::nullopt;
    is_good_ &= points.has_value();
    if (!points) return {};
    outlines_.front().marks = points->marks;
    return *std::move(points);
  }

  /// Reads the holes of a prism: holes along z, then x, then y, which is the order of
  /// solid::Fault::loop.
  void Holes(const Eigen::Vector3d& scale, solid::Prism& prism) {
    const spec::Field* field = entry_.Find(Key::kHoles);
    if (field == nullptr) return;
    const auto holes = reader_.Outlines(*field);
    is_good_ &= holes.has_value();
    if (!holes) return;
    for (const std::size_t axis : {2, 0, 1}) {
      std::vector<std::vector<Eigen::Vector2d>>& along = axis == 2   ? prism.holes
                                                         : axis == 0 ? prism.holes_x
                                                                     : prism.holes_y;
      const Eigen::Vector2d own_scale(scale[axis == 0 ? 1 : 0], scale[axis == 2 ? 1 : 2]);
      for (const sample::HoleOutline& hole : *holes) {
        if (hole.axis != axis) continue;
        along.push_back(PointsIn(hole.points, own_scale));
        outlines_.push_back({.name = NameOfHole(along.size(), axis), .marks = hole.points.marks});
      }
    }
  }

  /// Returns the `count` numbers of a required field. If `last` has a value, this value is the last
  /// number, and the field contains the others.
  sample::Numbers Numbers(Key key, std::string_view name, std::size_t count,
                          const std::optional<double>& last = std::nullopt) {
    field_ = Required(reader_, entry_, key, name, mark_);
    sample::Numbers numbers;
    is_good_ &= field_ != nullptr && reader_.Numbers(*field_, numbers) &&
                reader_.HasCount(*field_, numbers, count - (last ? 1 : 0));
    if (last) numbers.push_back(*last);
    numbers.resize(count);
    return numbers;
  }

  void Require(Key key, std::string_view name) {
    is_good_ &= Required(reader_, entry_, key, name, mark_) != nullptr;
  }

  /// Reports a field that other fields exclude. Ignores the field if it comes from the defaults.
  void Refuse(Key key, std::string_view why, std::string hint = {}) {
    const spec::Field* field = entry_.Find(key);
    if (field == nullptr || field->is_default) return;
    reader_.Report(diag::Code::kModelBadValue, *field, why, std::move(hint));
    is_good_ = false;
  }

  /// Returns the scale factors of x and y from the field `scale`.
  Eigen::Vector2d Scale() {
    const std::optional<sample::Numbers> scale = ReadScale(reader_, entry_, 2);
    is_good_ &= scale.has_value();
    return scale ? Eigen::Vector2d(scale->data()) : Eigen::Vector2d::Ones();
  }

  std::optional<std::vector<model::Part>> Make(const solid::SolidShape& shape, Assets& assets,
                                               model::Part& part) {
    if (!is_good_) return std::nullopt;
    return assets.AddShape(reader_, {.shape = shape, .field = *field_, .outlines = outlines_},
                           part);
  }

 private:
  template <typename T>
  T Read(Key key, std::optional<T> (FieldReader::*read)(const spec::Field&), T without) {
    is_good_ &= reader_.ReadOptional(entry_, key, read, without);
    return without;
  }

  FieldReader& reader_;
  const spec::Entry& entry_;
  diag::SourceMark mark_;
  std::vector<OutlinePlace> outlines_ = {OutlinePlace()};
  const spec::Field* field_ = nullptr;
  bool is_good_ = true;
};

solid::Lathe ReadLathe(SolidReader& read, const PartTexture& texture) {
  solid::Lathe lathe;
  lathe.wall = read.Wall();
  lathe.angle = read.Number(Key::kAngle, lathe.angle);
  lathe.crease = read.Number(Key::kCrease, lathe.crease);
  lathe.facets = read.Integer(Key::kFacets, lathe.facets);
  lathe.texture = texture.mapping;
  lathe.profile = PointsIn(read.Points(Key::kProfile, "profile"));
  return lathe;
}

solid::Prism ReadPrism(SolidReader& read, const PartTexture& texture) {
  solid::Prism prism;
  prism.height = read.Numbers(Key::kHeight, "height", 1)[0];
  prism.round = read.Number(Key::kRound, 0);
  prism.bevel = read.Number(Key::kBevel, 0);
  prism.crease = read.Number(Key::kCrease, prism.crease);
  const Eigen::Vector2d scale = read.Scale();
  prism.facets = read.Integer(Key::kFacets, prism.facets);
  read.Holes({scale.x(), scale.y(), 1}, prism);
  prism.polygon = PointsIn(read.Points(Key::kPolygon, "polygon"), scale);
  prism.texture = MappingFromAbove(texture, solid::BoxAround(prism.polygon).sizes());
  if (prism.holes_x.empty() && prism.holes_y.empty()) return prism;
  constexpr std::string_view kWhy = "has no meaning beside holes along x or y";
  read.Refuse(Key::kRound, kWhy,
              "round the polygon by arcs of points, as in {arc: [[x, y], radius, 0, 90deg]}");
  read.Refuse(Key::kBevel, kWhy, "leave it out");
  prism.round = prism.bevel = 0;  // values from defaults are ignored
  return prism;
}

// Reads a box with holes as a prism with a rectangle as its polygon.
solid::Prism ReadCutBox(SolidReader& read, const PartTexture& texture,
                        const std::optional<double>& half_length) {
  const sample::Numbers half = read.Numbers(Key::kSize, "size", 3, half_length);
  solid::Prism prism;
  prism.texture = MappingFromAbove(texture, {half[0], half[1]});
  prism.polygon = {
      {-half[0], -half[1]}, {half[0], -half[1]}, {half[0], half[1]}, {-half[0], half[1]}};
  prism.height = 2 * half[2];
  read.Holes(Eigen::Vector3d::Ones(), prism);
  read.Refuse(Key::kRound, "has no meaning for a box with holes",
              "use a prism, whose polygon can have round corners, or several parts");
  return prism;
}

solid::ConvexHull ReadHull(SolidReader& read, const PartTexture& texture) {
  solid::ConvexHull hull{.points = {}, .round = read.Number(Key::kRound, 0)};
  const sample::Numbers numbers = read.Points(Key::kPoints, "points").numbers;
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    box.extend(hull.points.emplace_back(&numbers[i]).head<2>());
  hull.texture = MappingFromAbove(texture, box.sizes());
  return hull;
}

solid::Tube ReadTube(SolidReader& read, const PartTexture& texture) {
  solid::Tube tube;
  tube.smooth = read.Flag(Key::kSmooth, false);
  tube.closed = read.Flag(Key::kClosed, false);
  tube.facets = read.Integer(Key::kFacets, tube.facets);
  tube.texture = texture.mapping;
  tube.wall = read.Wall();
  tube.bend = read.Number(Key::kBend, 0);
  tube.crease = read.Number(Key::kCrease, tube.crease);
  const double radius = read.Number(Key::kRadius, 0);
  const auto [per_point, numbers, marks] = read.Points(Key::kPath, "path");
  if (per_point == 3) read.Require(Key::kRadius, "radius");
  if (per_point == 4) read.Refuse(Key::kRadius, "is what each point's fourth number is, too");
  for (std::size_t i = 0; i + per_point <= numbers.size(); i += per_point) {
    tube.path.emplace_back(&numbers[i]);
    tube.radii.push_back(per_point == 4 ? numbers[i + 3] : radius);
  }
  return tube;
}

solid::RoundedBox ReadBox(SolidReader& read, const PartTexture& texture,
                          const std::optional<double>& half_length, model::Pose& X_FG) {
  solid::RoundedBox box;
  box.texture = texture.mapping;
  box.piece_is_plain = !read.Flag(Key::kRoundCollision, true);
  box.round = read.Number(Key::kRound, 0);
  box.half = Eigen::Vector3d(read.Numbers(Key::kSize, "size", 3, half_length).data());
  X_FG.q = X_FG.q * TurnToGrain(texture, box.half);
  return box;
}

solid::RoundedCylinder ReadCylinder(SolidReader& read, const PartTexture& texture,
                                    const std::optional<double>& half_length) {
  solid::RoundedCylinder cylinder;
  cylinder.piece_is_plain = !read.Flag(Key::kRoundCollision, true);
  cylinder.facets = read.Integer(Key::kFacets, cylinder.facets);
  cylinder.texture = texture.mapping;
  cylinder.round = read.Number(Key::kRound, 0);
  cylinder.crease = read.Number(Key::kCrease, cylinder.crease);
  const sample::Numbers size = read.Numbers(Key::kSize, "size", 2, half_length);
  cylinder.radius = size[0];
  cylinder.half = size[1];
  return cylinder;
}

solid::SolidShape ReadSolidShape(SolidReader& read, std::string_view type,
                                 const PartTexture& texture,
                                 const std::optional<double>& half_length, bool has_holes,
                                 model::Pose& X_FG) {
  if (type == "lathe") return ReadLathe(read, texture);
  if (type == "prism") return ReadPrism(read, texture);
  if (type == "tube") return ReadTube(read, texture);
  if (type == "hull") return ReadHull(read, texture);
  if (type == "box" && has_holes) return ReadCutBox(read, texture, half_length);
  if (type == "box") return ReadBox(read, texture, half_length, X_FG);
  return ReadCylinder(read, texture, half_length);
}

}  // namespace

bool IsSolid(std::string_view type, const spec::Entry& entry) {
  if (type == "box" && entry.Find(Key::kHoles) != nullptr) return true;
  if (type == "box" || type == "cylinder") return entry.Find(Key::kRound) != nullptr;
  return type == "prism" || type == "lathe" || type == "tube" || type == "hull";
}

bool ReadSolid(FieldReader& reader, const spec::Entry& entry, std::string_view type,
               const std::optional<double>& half_length, const PartTexture& texture, Assets& assets,
               model::Part& part, ShapePlacement& placed) {
  SolidReader read(reader, entry, part.mark);
  const bool has_holes = entry.Find(Key::kHoles) != nullptr;
  const solid::SolidShape shape =
      ReadSolidShape(read, type, texture, half_length, has_holes, placed.X_FG);
  std::optional<std::vector<model::Part>> pieces = read.Make(shape, assets, part);
  if (!pieces) return false;
  placed.pieces = *std::move(pieces);
  return true;
}

}  // namespace mjforge::assemble
