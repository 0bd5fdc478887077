// Functions of Evaluator that evaluate lists of points with loops and arcs, outlines, and the
// ranges of loops.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

// Maximum count of points of a shape; equals solid::kMostPoints.
constexpr std::size_t kMost = 1000;

// Calls `read` for each combination of the values of the loops, with the random stream of the
// combination, until `read` returns false. Returns false if `read` returned false, or if the range
// of a loop is invalid.
template <typename Function>
bool ForEachCombination(Evaluator& values, std::span<const spec::Loop> loops, StreamId path,
                        const Function& read) {
  if (loops.empty()) return read(path);
  const std::optional<LoopRange> range = values.RangeOf(loops.front());
  if (!range) return false;
  for (std::size_t i = 0; i < range->count; ++i) {
    values.SetVariable(loops.front(), *range, i);
    if (!ForEachCombination(values, loops.subspan(1), Child(path, i), read)) return false;
  }
  return true;
}

// Arc through three points in space, in coordinates of the plane of the points: x points from the
// first to the second point, y to the side of the last point, and the origin is the first point.
class CircleThrough {
 public:
  /// Returns the arc through three points; nullopt if the points are on a straight line.
  static std::optional<CircleThrough> Of(const Numbers& first, const Numbers& second,
                                         const Numbers& last) {
    CircleThrough circle;
    const Vector b = Minus(second, first);
    const Vector c = Minus(last, first);
    const double to_b = std::sqrt(Dot(b, b));
    const double size = to_b + std::sqrt(Dot(c, c));
    if (!(to_b > kSame * size)) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) circle.x_[i] = b[i] / to_b;
    const double along = Dot(c, circle.x_);
    for (std::size_t i = 0; i < 3; ++i) circle.y_[i] = c[i] - along * circle.x_[i];
    const double across = std::sqrt(Dot(circle.y_, circle.y_));
    if (!(across > kSame * size)) return std::nullopt;
    for (double& number : circle.y_) number /= across;
    const double u = to_b / 2;
    const double v = (along * along + across * across - to_b * along) / (2 * across);
    circle.first_ = {first[0], first[1], first[2]};
    circle.u_ = u;
    circle.v_ = v;
    circle.radius_ = std::sqrt(u * u + v * v);
    circle.from_ = std::atan2(-v, -u);
    // The arc is counter-clockwise, because the last point is on the left of the line from the
    // first to the second point.
    circle.to_second_ = After(circle.from_, std::atan2(-v, to_b - u));
    circle.to_last_ = After(circle.from_, std::atan2(across - v, along - u));
    return circle;
  }

  void MoveTo(double share, Numbers& point) const {
    const double angle = from_ + share * to_last_;
    const double along = u_ + radius_ * std::cos(angle);
    const double across = v_ + radius_ * std::sin(angle);
    for (std::size_t i = 0; i < 3; ++i) point[i] = first_[i] + along * x_[i] + across * y_[i];
  }

  /// Interpolates a quantity that is given at the three points, and returns its value at the
  /// fraction `share` of the arc. The quantity is linear in the angle between two of the points.
  double Between(double share, double first, double second, double last) const {
    const double angle = share * to_last_;
    if (angle <= to_second_) return std::lerp(first, second, angle / to_second_);
    return std::lerp(second, last, (angle - to_second_) / (to_last_ - to_second_));
  }

 private:
  using Vector = std::array<double, 3>;
  static constexpr double kSame = 1e-9;  // relative tolerance for coinciding or collinear points

  static Vector Minus(const Numbers& a, const Numbers& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static double Dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  /// Returns the counter-clockwise angle from `start` to `end`, rad.
  static double After(double start, double end) {
    return end > start ? end - start : end - start + 2 * std::numbers::pi;
  }

  Vector first_ = {};
  Vector x_ = {};
  Vector y_ = {};
  double u_ = 0;  // coordinates of the centre along x and y
  double v_ = 0;
  double radius_ = 0;
  double from_ = 0;  // angle of the first point, rad
  double to_second_ = 0;
  double to_last_ = 0;
};

// Reader of a single list of points. Member functions return false after adding a finding, or if
// the list has too many points.
class PointReader {
 public:
  explicit PointReader(Evaluator& values) : values_(values) {}

  bool Read(const spec::Value& item, StreamId path) {
    bool is_good = true;
    if (const auto* loop = std::get_if<spec::PointLoop>(&item.form)) {
      const auto read = [&](StreamId own) { return ReadPoint(*loop->at, own); };
      is_good = ForEachCombination(values_, *loop->loops, path, read);
    } else if (const auto* arc = std::get_if<spec::Arc>(&item.form)) {
      is_good = ReadArc(*arc, path);
    } else {
      is_good = ReadPoint(item, path);
    }
    points_.marks.resize(count_, item.mark);
    if (count_ <= kMost) return is_good;
    values_.Fail(diag::Code::kSampleBadArgument, item.mark,
                 fmt::format("the list has more than {} points", kMost));
    return false;
  }

  PointList Take() { return std::move(points_); }

 private:
  bool ReadPoint(const spec::Value& point, StreamId path) {
    Numbers numbers;
    values_.Vector(point, path, numbers);
    return !HasFailedNumber(numbers) && Add(numbers, point.mark);
  }

  bool Add(const Numbers& numbers, diag::SourceMark mark) {
    if (count_ == 0) points_.per_point = numbers.size();
    if (points_.per_point != numbers.size())
      return Refuse(mark, fmt::format("this point has {} numbers, those before it have {}",
                                      numbers.size(), points_.per_point));
    points_.numbers.insert(points_.numbers.end(), numbers.begin(), numbers.end());
    return ++count_ <= kMost;
  }

  bool ReadArc(const spec::Arc& arc, StreamId path) {
    Numbers center;
    values_.Vector(*arc.center, Child(path, "center"), center);
    const std::optional<double> steps = StepsOf(arc, path);
    if (arc.measures.size() == 2) return ReadArcThrough(arc, center, steps, path);
    Numbers measures;
    for (std::size_t i = 0; i < arc.measures.size(); ++i)
      measures.push_back(values_.Number(arc.measures[i], Child(path, i)));
    if (HasFailedNumber(center) || HasFailedNumber(measures) || !steps) return false;
    const double radius = measures[0];
    const auto axis = static_cast<std::size_t>(measures.size() > 3 ? measures[3] : 2);
    for (double i = 0; i <= *steps; ++i) {
      const double angle = measures[1] + i / *steps * (measures[2] - measures[1]);
      Numbers point = center;
      point[(axis + 1) % 3] += radius * std::cos(angle);
      point[(axis + 2) % 3] += radius * std::sin(angle);
      if (!AddToArc(arc, point)) return false;
    }
    return true;
  }

  // Returns the count of an arc's steps; nullopt after adding a finding.
  std::optional<double> StepsOf(const spec::Arc& arc, StreamId path) {
    const double steps = values_.Number(*arc.steps, Child(path, "steps"));
    if (std::isnan(steps)) return std::nullopt;
    if (steps >= 1 && steps <= kMost && steps == std::floor(steps)) return steps;
    values_.Fail(diag::Code::kSampleBadArgument, arc.steps->mark,
                 fmt::format("`steps` of the arc is {}; it must be a whole number, 1 to {}",
                             expr::NumberText(steps), kMost));
    return std::nullopt;
  }

  bool ReadArcThrough(const spec::Arc& arc, const Numbers& first, std::optional<double> steps,
                      StreamId path) {
    Numbers second;
    Numbers last;
    values_.Vector(arc.measures[0], Child(path, std::size_t{0}), second);
    values_.Vector(arc.measures[1], Child(path, std::size_t{1}), last);
    if (HasFailedNumber(first) || HasFailedNumber(second) || HasFailedNumber(last)) return false;
    if (!steps) return false;
    if (first.size() != second.size() || first.size() != last.size())
      return Refuse(arc.center->mark,
                    "the three points of the arc have different counts of numbers");
    const std::optional<CircleThrough> circle = CircleThrough::Of(first, second, last);
    if (!circle) return Refuse(arc.center->mark, "the three points of the arc are on a line");
    for (double i = 0; i <= *steps; ++i) {
      const bool is_end = i == 0 || i == *steps;
      Numbers point = i == 0 ? first : last;
      if (!is_end) circle->MoveTo(i / *steps, point);
      // Points of a tube may have a fourth number, the radius, which is interpolated between the
      // three points.
      if (!is_end && point.size() == 4)
        point[3] = circle->Between(i / *steps, first[3], second[3], last[3]);
      if (!AddToArc(arc, point)) return false;
    }
    return true;
  }

  // Adds a finding, and returns false.
  bool Refuse(diag::SourceMark mark, std::string why) {
    values_.Fail(diag::Code::kSampleBadArgument, mark, std::move(why));
    return false;
  }

  bool AddToArc(const spec::Arc& arc, const Numbers& point) {
    if (!std::ranges::all_of(point, [](double number) { return std::isfinite(number); }))
      return Refuse(arc.center->mark, "the arc has a point that is not finite");
    return Add(point, arc.center->mark);
  }

  Evaluator& values_;
  PointList points_;
  std::size_t count_ = 0;
};

}  // namespace

std::optional<PointList> Evaluator::Points(const spec::Value& value, StreamId path) {
  if (const spec::Draw* choice = ChoiceOf(value)) {
    const spec::Value* chosen = Choose(*choice, value.mark, path);
    return chosen != nullptr ? Points(*chosen, path) : std::nullopt;
  }
  const auto* list = std::get_if<spec::List>(&value.form);
  if (list == nullptr) {
    Fail(diag::Code::kSampleBadArgument, value.mark, "this value is not a list of points");
    return std::nullopt;
  }
  PointReader reader(*this);
  for (std::size_t i = 0; i < list->items.size(); ++i) {
    if (!reader.Read(list->items[i], Child(path, i))) return std::nullopt;
  }
  return reader.Take();
}

std::optional<std::vector<HoleOutline>> Evaluator::Outlines(const spec::Value& value,
                                                            StreamId path) {
  std::vector<HoleOutline> outlines;
  const auto read = [&](const spec::Value& item, StreamId own) {
    if (const auto* along = std::get_if<spec::AxisOutlines>(&item.form)) {
      std::optional<std::vector<HoleOutline>> others = Outlines(*along->outlines, own);
      if (!others) return false;
      for (HoleOutline& outline : *others) {
        outline.axis = along->axis;
        outlines.push_back(std::move(outline));
      }
      return outlines.size() <= kMost;
    }
    std::optional<PointList> points = Points(item, own);
    if (!points) return false;
    outlines.push_back({.points = *std::move(points)});
    return outlines.size() <= kMost;
  };
  const auto* list = std::get_if<spec::List>(&value.form);
  for (std::size_t i = 0; list != nullptr && i < list->items.size(); ++i) {
    const spec::Value& item = list->items[i];
    const auto* loop = std::get_if<spec::PointLoop>(&item.form);
    const auto read_one = [&](StreamId own) {
      return read(loop != nullptr ? *loop->at : item, own);
    };
    const std::span<const spec::Loop> loops =
        loop != nullptr ? std::span<const spec::Loop>(*loop->loops) : std::span<const spec::Loop>();
    if (ForEachCombination(*this, loops, Child(path, i), read_one)) continue;
    if (outlines.size() <= kMost) return std::nullopt;
  }
  return outlines;
}

std::optional<LoopRange> Evaluator::RangeOf(const spec::Loop& loop) {
  const StreamId path = Child(root(), std::string_view(loop.variable));
  if (loop.over_values()) {
    std::optional<Items> items = List(loop.range, path);
    if (!items) return std::nullopt;
    const std::size_t count = items->numbers.size();
    return LoopRange{.count = count, .items = std::move(items)};
  }
  const double count = Number(loop.range, path);
  if (std::isnan(count)) return std::nullopt;
  if (count < 0 || count != std::floor(count)) {
    Fail(diag::Code::kModelBadCount, loop.range.mark,
         fmt::format("count of loop '{}' is {}; it must be a whole number, 0 or more",
                     loop.variable, expr::NumberText(count)));
    return std::nullopt;
  }
  return LoopRange{.count = static_cast<std::size_t>(std::min(count, 1e15)), .items = {}};
}

}  // namespace mjforge::sample
