// Lists of points.

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

// Numbers of the points that a shape may have; see solid::kMostPoints.
constexpr std::size_t kMost = 2 * 1000;

class PointReader {
 public:
  PointReader(Evaluator& values, Numbers& out) : values_(values), out_(out) {}

  void Read(const spec::Value& item, StreamId path) {
    if (const auto* loop = std::get_if<spec::PointLoop>(&item.form)) {
      ReadLoop(*loop, 0, path);
    } else if (const auto* arc = std::get_if<spec::Arc>(&item.form)) {
      ReadArc(*arc, path);
    } else {
      ReadPoint(item, path);
    }
  }

 private:
  void ReadPoint(const spec::Value& point, StreamId path) {
    Numbers numbers;
    values_.Vector(point, path, numbers);
    out_.insert(out_.end(), numbers.begin(), numbers.end());
  }

  void ReadLoop(const spec::PointLoop& points, std::size_t depth, StreamId path) {
    if (depth == points.loops->size()) return ReadPoint(*points.at, path);
    const spec::Loop& loop = (*points.loops)[depth];
    const std::optional<LoopRange> range = values_.RangeOf(loop);
    for (std::size_t i = 0; range && i < range->count; ++i) {
      if (values_.failed() || out_.size() > kMost) return;
      values_.SetVariable(loop, *range, i);
      ReadLoop(points, depth + 1, Child(path, i));
    }
  }

  void ReadArc(const spec::Arc& arc, StreamId path) {
    Numbers center;
    values_.Vector(*arc.center, Child(path, "center"), center);
    std::array<Traced<double>, 3> measures;
    for (std::size_t i = 0; i < measures.size(); ++i)
      measures[i] = values_.Number(arc.measures[i], Child(path, i));
    const double steps = values_.FixedNumber(*arc.steps, Child(path, "steps"));
    if (values_.failed() || !(steps >= 1 && steps <= kMost)) return;
    const auto& [radius, from, to] = measures;
    for (double i = 0; i <= steps; ++i) {
      const auto x = [share = i / steps](double middle, double r, double begin, double end) {
        return middle + r * std::cos(begin + share * (end - begin));
      };
      const auto y = [share = i / steps](double middle, double r, double begin, double end) {
        return middle + r * std::sin(begin + share * (end - begin));
      };
      out_.push_back(tape::Apply(x, center[0], radius, from, to));
      out_.push_back(tape::Apply(y, center[1], radius, from, to));
    }
  }

  Evaluator& values_;
  Numbers& out_;
};

}  // namespace

PointList Evaluator::Points(const spec::Value& value, StreamId path) {
  if (const auto* draw = std::get_if<spec::Draw>(&value.form); draw && IsPick(*draw)) {
    const spec::Value& chosen = Chosen(*draw, value.mark, path);
    return Points(chosen, path);
  }
  PointList points;
  const auto* list = std::get_if<spec::List>(&value.form);
  if (list == nullptr) {
    Fail(diag::Code::kSampleBadArgument, value.mark, "this value is not a list of points");
    return points;
  }
  PointReader reader(*this, points.numbers);
  for (std::size_t i = 0; i < list->items.size() && !failed_; ++i) {
    const spec::Value& item = list->items[i];
    reader.Read(item, Child(path, i));
    points.marks.resize(points.numbers.size() / 2, item.mark);
    if (points.numbers.size() <= kMost) continue;
    Fail(diag::Code::kSampleBadArgument, item.mark,
         fmt::format("the list has more than {} points", kMost / 2));
  }
  return points;
}

std::optional<LoopRange> Evaluator::RangeOf(const spec::Loop& loop) {
  const StreamId path = Child(root(), std::string_view(loop.variable));
  if (loop.over_values()) {
    LoopRange range{.count = 0, .items = List(loop.range, path)};
    range.count = range.items->numbers.size();
    return range;
  }
  const double count = FixedNumber(loop.range, path);
  if (!std::isfinite(count)) return std::nullopt;  // reported where it was computed
  if (count < 0 || count != std::floor(count)) {
    Fail(diag::Code::kModelBadCount, loop.range.mark,
         fmt::format("count of loop '{}' is {}; it must be a whole number, 0 or more",
                     loop.variable, expr::NumberText(count)));
    return std::nullopt;
  }
  return LoopRange{.count = static_cast<std::size_t>(std::min(count, 1e15)), .items = {}};
}

void Evaluator::SetVariable(const spec::Loop& loop, const LoopRange& range, std::size_t i) {
  if (!range.items) {
    SetVariable(loop.slot, static_cast<double>(i));
  } else if (loop.range.type == expr::Type::kText) {
    SetVariable(loop.slot, range.items->texts[i]);
  } else {
    SetVariable(loop.slot, range.items->numbers[i]);
  }
}

}  // namespace mjforge::sample
