// Evaluator: evaluates lists of points with loops and arcs, outlines, and the ranges of loops.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

constexpr std::size_t kMost = 1000;  // points of a shape; equals solid::kMostPoints

// Calls `read` with the stream of each combination of the loops' values, until it returns false.
// Returns false if it did, or if a range failed.
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

// The points of one list. Its functions return false after a finding, or if the list is full.
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
    if (HasFailedNumber(numbers)) return false;
    if (count_ == 0) points_.per_point = numbers.size();
    if (points_.per_point != numbers.size()) {
      values_.Fail(diag::Code::kSampleBadArgument, point.mark,
                   fmt::format("this point has {} numbers, those before it have {}", numbers.size(),
                               points_.per_point));
      return false;
    }
    points_.numbers.insert(points_.numbers.end(), numbers.begin(), numbers.end());
    return ++count_ <= kMost;
  }

  bool ReadArc(const spec::Arc& arc, StreamId path) {
    Numbers center;
    values_.Vector(*arc.center, Child(path, "center"), center);
    std::array<double, 3> measures;
    for (std::size_t i = 0; i < measures.size(); ++i)
      measures[i] = values_.Number(arc.measures[i], Child(path, i));
    const double steps = values_.Number(*arc.steps, Child(path, "steps"));
    if (HasFailedNumber(center) || HasFailedNumber(measures) || std::isnan(steps)) return false;
    if (!(steps >= 1 && steps <= 2 * kMost)) return true;
    const auto& [radius, from, to] = measures;
    for (double i = 0; i <= steps; ++i) {
      const double angle = from + i / steps * (to - from);
      const double x = center[0] + radius * std::cos(angle);
      const double y = center[1] + radius * std::sin(angle);
      if (!std::isfinite(x) || !std::isfinite(y)) {
        values_.Fail(diag::Code::kSampleBadArgument, arc.center->mark,
                     "the arc has a point that is not finite");
        return false;
      }
      points_.numbers.insert(points_.numbers.end(), {x, y});
      ++count_;
    }
    return true;
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

std::optional<std::vector<PointList>> Evaluator::Outlines(const spec::Value& value, StreamId path) {
  std::vector<PointList> outlines;
  const auto read = [&](const spec::Value& points, StreamId own) {
    std::optional<PointList> outline = Points(points, own);
    if (!outline) return false;
    outlines.push_back(*std::move(outline));
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
