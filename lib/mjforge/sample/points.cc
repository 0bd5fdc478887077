// Lists of points.

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

constexpr std::size_t kMost = 1000;  // points of a shape; see solid::kMostPoints

class PointReader {
 public:
  explicit PointReader(Evaluator& values) : values_(values) {}

  void Read(const spec::Value& item, StreamId path) {
    if (const auto* loop = std::get_if<spec::PointLoop>(&item.form)) {
      const auto read = [&](StreamId own) { ReadPoint(*loop->at, own); };
      Repeat(
          values_, *loop, 0, path, [&] { return IsFull(); }, read);
    } else if (const auto* arc = std::get_if<spec::Arc>(&item.form)) {
      ReadArc(*arc, path);
    } else {
      ReadPoint(item, path);
    }
    points_.marks.resize(count_, item.mark);
    if (!IsFull() || values_.failed()) return;
    values_.Fail(diag::Code::kSampleBadArgument, item.mark,
                 fmt::format("the list has more than {} points", kMost));
  }

  /// Calls `read` with the path of each combination of the loops' values.
  template <typename IsDone, typename Function>
  static void Repeat(Evaluator& values, const spec::PointLoop& points, std::size_t depth,
                     StreamId path, const IsDone& is_done, const Function& read) {
    if (depth == points.loops->size()) return read(path);
    const spec::Loop& loop = (*points.loops)[depth];
    const std::optional<LoopRange> range = values.RangeOf(loop);
    for (std::size_t i = 0; range && i < range->count; ++i) {
      if (values.failed() || is_done()) return;
      values.SetVariable(loop, *range, i);
      Repeat(values, points, depth + 1, Child(path, i), is_done, read);
    }
  }

  PointList Take() { return std::move(points_); }

 private:
  bool IsFull() const { return count_ > kMost; }

  void ReadPoint(const spec::Value& point, StreamId path) {
    Numbers numbers;
    values_.Vector(point, path, numbers);
    if (values_.failed()) return;
    if (count_ == 0) points_.per_point = numbers.size();
    if (points_.per_point != numbers.size()) {
      values_.Fail(diag::Code::kSampleBadArgument, point.mark,
                   fmt::format("this point has {} numbers, those before it have {}", numbers.size(),
                               points_.per_point));
      return;
    }
    ++count_;
    points_.numbers.insert(points_.numbers.end(), numbers.begin(), numbers.end());
  }

  void ReadArc(const spec::Arc& arc, StreamId path) {
    Numbers center;
    values_.Vector(*arc.center, Child(path, "center"), center);
    std::array<double, 3> measures;
    for (std::size_t i = 0; i < measures.size(); ++i)
      measures[i] = values_.Number(arc.measures[i], Child(path, i));
    const double steps = values_.Number(*arc.steps, Child(path, "steps"));
    if (values_.failed() || !(steps >= 1 && steps <= 2 * kMost)) return;
    const auto& [radius, from, to] = measures;
    for (double i = 0; i <= steps; ++i) {
      const double angle = from + i / steps * (to - from);
      points_.numbers.push_back(center[0] + radius * std::cos(angle));
      points_.numbers.push_back(center[1] + radius * std::sin(angle));
      ++count_;
    }
  }

  Evaluator& values_;
  PointList points_;
  std::size_t count_ = 0;
};

}  // namespace

PointList Evaluator::Points(const spec::Value& value, StreamId path) {
  if (const auto* draw = std::get_if<spec::Draw>(&value.form); draw && IsPick(*draw)) {
    const spec::Value& chosen = Chosen(*draw, value.mark, path);
    return Points(chosen, path);
  }
  const auto* list = std::get_if<spec::List>(&value.form);
  if (list == nullptr) {
    Fail(diag::Code::kSampleBadArgument, value.mark, "this value is not a list of points");
    return {};
  }
  PointReader reader(*this);
  for (std::size_t i = 0; i < list->items.size() && !failed_; ++i)
    reader.Read(list->items[i], Child(path, i));
  return reader.Take();
}

std::vector<PointList> Evaluator::Outlines(const spec::Value& value, StreamId path) {
  std::vector<PointList> outlines;
  const auto* list = std::get_if<spec::List>(&value.form);
  for (std::size_t i = 0; list != nullptr && i < list->items.size() && !failed_; ++i) {
    const spec::Value& item = list->items[i];
    const auto* loop = std::get_if<spec::PointLoop>(&item.form);
    if (loop == nullptr) {
      outlines.push_back(Points(item, Child(path, i)));
      continue;
    }
    const auto read = [&](StreamId own) { outlines.push_back(Points(*loop->at, own)); };
    const auto is_full = [&] { return outlines.size() > kMost; };
    PointReader::Repeat(*this, *loop, 0, Child(path, i), is_full, read);
  }
  return outlines;
}

std::optional<LoopRange> Evaluator::RangeOf(const spec::Loop& loop) {
  const StreamId path = Child(root(), std::string_view(loop.variable));
  if (loop.over_values()) {
    LoopRange range{.count = 0, .items = List(loop.range, path)};
    range.count = range.items->numbers.size();
    return range;
  }
  const double count = Number(loop.range, path);
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
