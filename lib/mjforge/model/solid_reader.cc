#include "mjforge/model/solid_reader.h"

#include <algorithm>
#include <utility>

namespace mjforge::model {
namespace {

using spec::Key;
using ShapeOf = std::function<solid::SolidShape(std::span<const double>)>;

/// Collects the numbers of a shape, in the order in which its function takes them.
class SolidReader {
 public:
  SolidReader(FieldReader& reader, const spec::Entry& entry, diag::SourceMark mark)
      : reader_(reader), entry_(entry), mark_(mark) {}

  const spec::Field* Find(Key key) const { return entry_.Find(key); }

  /// Notes a number that may vary.
  void Add(Key key, double without) { input_.numbers.push_back(Number(key, without)); }

  int Integer(Key key, int without) { return static_cast<int>(tape::Fixed(Number(key, without))); }

  bool Flag(Key key, bool without) {
    const spec::Field* field = Find(key);
    if (field == nullptr) return without;
    const std::optional<bool> flag = reader_.Boolean(*field);
    good_ &= flag.has_value();
    return flag.value_or(without);
  }

  /// Notes all numbers of the points; how many a point has.
  std::size_t AddPoints(Key key, std::string_view name) {
    field_ = Required(reader_, entry_, key, name, mark_);
    const auto points = field_ != nullptr ? reader_.Points(*field_) : std::nullopt;
    good_ &= points.has_value();
    if (!points) return 0;
    AddList(*points);
    // Its faults are told as those of the first outline.
    std::rotate(input_.marks.begin(), input_.marks.end() - 1, input_.marks.end());
    return points->per_point;
  }

  /// How many points each has.
  std::vector<std::size_t> AddOutlines(Key key) {
    std::vector<std::size_t> counts;
    const spec::Field* field = Find(key);
    if (field == nullptr) return counts;
    const auto outlines = reader_.Outlines(*field);
    good_ &= outlines.has_value();
    if (!outlines) return counts;
    for (const sample::PointList& outline : *outlines) {
      AddList(outline);
      counts.push_back(outline.marks.size());
    }
    return counts;
  }

  /// Notes the numbers of a list of that many. `last`: what is taken for the last of them.
  void AddNumbers(Key key, std::string_view name, std::size_t count,
                  const std::optional<Traced<double>>& last = std::nullopt) {
    field_ = Required(reader_, entry_, key, name, mark_);
    sample::Numbers numbers;
    good_ &= field_ != nullptr && reader_.Numbers(*field_, numbers) &&
             reader_.HasCount(*field_, numbers, count - (last ? 1 : 0));
    if (last) numbers.push_back(*last);
    input_.numbers.insert(input_.numbers.end(), numbers.begin(), numbers.end());
  }

  void Require(Key key, std::string_view name) {
    good_ &= Required(reader_, entry_, key, name, mark_) != nullptr;
  }

  void Refuse(Key key, std::string_view why) {
    const spec::Field* field = Find(key);
    if (field == nullptr || field->is_default) return;
    reader_.Report(diag::Code::kModelBadValue, *field, why);
    good_ = false;
  }

  /// Notes the factors of x and y.
  void AddScale() {
    const std::optional<sample::Numbers> scale = ReadScale(reader_, entry_, 2);
    good_ &= scale.has_value();
    if (scale) input_.numbers.insert(input_.numbers.end(), scale->begin(), scale->end());
  }

  void SetTurnsVary(std::size_t number) {
    input_.turns_vary = input_.numbers[number].tape() != nullptr;
  }

  std::optional<std::vector<Part>> Make(ShapeOf shape_of, Assets& assets, Part& part) {
    if (!good_) return std::nullopt;
    input_.shape_of = std::move(shape_of);
    return assets.AddShape(reader_, *field_, input_, part);
  }

 private:
  Traced<double> Number(Key key, double without) {
    const spec::Field* field = Find(key);
    if (field == nullptr) return without;
    const std::optional<Traced<double>> number = reader_.Number(*field);
    good_ &= number.has_value();
    return number.value_or(without);
  }

  void AddList(const sample::PointList& points) {
    input_.numbers.insert(input_.numbers.end(), points.numbers.begin(), points.numbers.end());
    input_.marks.push_back(points.marks);
  }

  FieldReader& reader_;
  const spec::Entry& entry_;
  diag::SourceMark mark_;
  SolidInput input_;
  const spec::Field* field_ = nullptr;  // what faults are told of
  bool good_ = true;
};

std::vector<Eigen::Vector2d> PointsIn(std::span<const double> numbers) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
    points.emplace_back(numbers[i], numbers[i + 1]);
  return points;
}

ShapeOf LatheOf(SolidReader& read, const solid::TextureMapping& texture) {
  solid::Lathe lathe;
  const bool has_wall = read.Find(Key::kWall) != nullptr;
  read.Add(Key::kWall, 0);
  read.Add(Key::kAngle, lathe.angle);
  read.SetTurnsVary(1);
  read.Add(Key::kCrease, lathe.crease);
  lathe.facets = read.Integer(Key::kFacets, lathe.facets);
  lathe.texture = texture;
  read.AddPoints(Key::kProfile, "profile");
  return [lathe, has_wall](std::span<const double> numbers) mutable {
    if (has_wall) lathe.wall = numbers[0];
    lathe.angle = numbers[1];
    lathe.crease = numbers[2];
    lathe.profile = PointsIn(numbers.subspan(3));
    return lathe;
  };
}

ShapeOf PrismOf(SolidReader& read, const solid::TextureMapping& texture) {
  solid::Prism prism;
  read.AddNumbers(Key::kHeight, "height", 1);
  read.Add(Key::kRound, 0);
  read.Add(Key::kBevel, 0);
  read.Add(Key::kCrease, prism.crease);
  read.AddScale();
  prism.facets = read.Integer(Key::kFacets, prism.facets);
  prism.texture = texture;
  const std::vector<std::size_t> holes = read.AddOutlines(Key::kHoles);
  read.AddPoints(Key::kPolygon, "polygon");
  return [prism, holes](std::span<const double> numbers) mutable {
    prism.height = numbers[0];
    prism.round = numbers[1];
    prism.bevel = numbers[2];
    prism.crease = numbers[3];
    const Eigen::Vector2d scale(numbers[4], numbers[5]);
    std::span<const double> left = numbers.subspan(6);
    const auto take = [&](std::size_t count) {
      std::vector<Eigen::Vector2d> points = PointsIn(left.first(2 * count));
      for (Eigen::Vector2d& point : points) point = point.cwiseProduct(scale);
      left = left.subspan(2 * count);
      return points;
    };
    prism.holes.clear();
    for (const std::size_t count : holes) prism.holes.push_back(take(count));
    prism.polygon = take(left.size() / 2);
    return prism;
  };
}

ShapeOf HullOf(SolidReader& read, const solid::TextureMapping& texture) {
  read.Add(Key::kRound, 0);
  read.AddPoints(Key::kPoints, "points");
  return [texture](std::span<const double> numbers) {
    solid::ConvexHull hull{.points = {}, .round = numbers[0], .texture = texture};
    for (std::size_t i = 1; i + 2 < numbers.size(); i += 3)
      hull.points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return hull;
  };
}

ShapeOf TubeOf(SolidReader& read, const solid::TextureMapping& texture) {
  solid::Tube tube;
  const bool has_wall = read.Find(Key::kWall) != nullptr;
  tube.smooth = read.Flag(Key::kSmooth, false);
  tube.closed = read.Flag(Key::kClosed, false);
  tube.facets = read.Integer(Key::kFacets, tube.facets);
  tube.texture = texture;
  read.Add(Key::kWall, 0);
  read.Add(Key::kBend, 0);
  read.Add(Key::kCrease, tube.crease);
  read.Add(Key::kRadius, 0);
  const std::size_t per_point = read.AddPoints(Key::kPath, "path");
  if (per_point == 3) read.Require(Key::kRadius, "radius");
  if (per_point == 4) read.Refuse(Key::kRadius, "is what each point's fourth number is, too");
  return [tube, has_wall, per_point](std::span<const double> numbers) mutable {
    if (has_wall) tube.wall = numbers[0];
    tube.bend = numbers[1];
    tube.crease = numbers[2];
    tube.path.clear();
    tube.radii.clear();
    for (std::size_t i = 4; i + per_point <= numbers.size(); i += per_point) {
      tube.path.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
      tube.radii.push_back(per_point == 4 ? numbers[i + 3] : numbers[3]);
    }
    return tube;
  };
}

ShapeOf BoxOf(SolidReader& read, const solid::TextureMapping& texture,
              const std::optional<Traced<double>>& half_length) {
  solid::RoundedBox box;
  box.texture = texture;
  box.piece_is_plain = !read.Flag(Key::kRoundCollision, true);
  read.Add(Key::kRound, 0);
  read.AddNumbers(Key::kSize, "size", 3, half_length);
  return [box](std::span<const double> numbers) mutable {
    box.round = numbers[0];
    box.half = Eigen::Vector3d(numbers[1], numbers[2], numbers[3]);
    return box;
  };
}

ShapeOf CylinderOf(SolidReader& read, const solid::TextureMapping& texture,
                   const std::optional<Traced<double>>& half_length) {
  solid::RoundedCylinder cylinder;
  cylinder.piece_is_plain = !read.Flag(Key::kRoundCollision, true);
  cylinder.facets = read.Integer(Key::kFacets, cylinder.facets);
  cylinder.texture = texture;
  read.Add(Key::kRound, 0);
  read.Add(Key::kCrease, cylinder.crease);
  read.AddNumbers(Key::kSize, "size", 2, half_length);
  return [cylinder](std::span<const double> numbers) mutable {
    cylinder.round = numbers[0];
    cylinder.crease = numbers[1];
    cylinder.radius = numbers[2];
    cylinder.half = numbers[3];
    return cylinder;
  };
}

}  // namespace

bool IsSolid(std::string_view type, const spec::Entry& entry) {
  if (type == "box" || type == "cylinder") return entry.Find(Key::kRound) != nullptr;
  return type == "prism" || type == "lathe" || type == "tube" || type == "hull";
}

std::optional<std::vector<Part>> ReadSolid(FieldReader& reader, const spec::Entry& entry,
                                           std::string_view type,
                                           const std::optional<Traced<double>>& half_length,
                                           const solid::TextureMapping& texture, Assets& assets,
                                           Part& part) {
  SolidReader read(reader, entry, part.mark);
  ShapeOf shape_of = type == "lathe"   ? LatheOf(read, texture)
                     : type == "prism" ? PrismOf(read, texture)
                     : type == "tube"  ? TubeOf(read, texture)
                     : type == "hull"  ? HullOf(read, texture)
                     : type == "box"   ? BoxOf(read, texture, half_length)
                                       : CylinderOf(read, texture, half_length);
  return read.Make(std::move(shape_of), assets, part);
}

}  // namespace mjforge::model
