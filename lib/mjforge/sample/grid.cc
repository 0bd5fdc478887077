// Grid sampling: levels of each dimension, and the coordinates of a point.

#include "mjforge/sample/grid.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace mjforge::sample {
namespace {

constexpr std::uint64_t kMany = std::numeric_limits<std::uint64_t>::max();

// Returns a * b, or kMany if the product does not fit into 64 bits.
std::uint64_t Product(std::uint64_t a, std::uint64_t b) {
  return a != 0 && b > kMany / a ? kMany : a * b;
}

// Returns the number of points of a grid of `count` dimensions, of which `more` have `low` + 1
// levels and all others `low` levels: low^(count - more) * (low + 1)^more, at most kMany.
std::uint64_t PointsOf(std::uint64_t low, std::size_t count, std::size_t more) {
  std::uint64_t points = 1;
  for (std::size_t i = 0; i < count; ++i) points = Product(points, i < more ? low + 1 : low);
  return points;
}

// Returns the centre of the cell in (0, 1) that belongs to a level.
double CentreOf(std::uint64_t level, std::uint64_t levels, std::optional<double> split) {
  if (split) return level == 0 ? *split / 2 : (1 + *split) / 2;
  return (static_cast<double>(level) + 0.5) / static_cast<double>(levels);
}

}  // namespace

Grid::Grid(std::span<const ParameterStream> streams, std::uint64_t size) {
  for (const ParameterStream& stream : streams) {
    if (stream.is_order) continue;  // sort keys on a grid would not give all orders of a list
    const auto count = static_cast<std::size_t>(stream.numbers);
    axes_of_.emplace(stream.stream, Axes{axes_.size(), count});
    axes_.insert(axes_.end(), count, Axis{stream.levels, 1, stream.split});
  }
  ShareLevels(size);
  for (auto axis = axes_.rbegin(); axis != axes_.rend(); ++axis) {
    axis->stride = points_;
    points_ = Product(points_, axis->levels);
  }
}

void Grid::ShareLevels(std::uint64_t size) {
  std::uint64_t discrete = 1;
  std::vector<Axis*> open;
  for (Axis& axis : axes_) {
    if (axis.levels == 0) {
      open.push_back(&axis);
    } else {
      discrete = Product(discrete, axis.levels);
    }
  }
  if (open.empty()) return;
  const std::uint64_t wanted = std::max<std::uint64_t>(1, size / discrete);
  std::uint64_t low = 1;
  std::uint64_t high = wanted;  // binary search for the number of levels of all open axes
  while (low < high) {
    const std::uint64_t middle = high - (high - low) / 2;
    if (PointsOf(middle, open.size(), 0) <= wanted) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  std::size_t more = 0;
  while (more < open.size() && PointsOf(low, open.size(), more + 1) <= wanted) ++more;
  for (std::size_t i = 0; i < open.size(); ++i) open[i]->levels = i < more ? low + 1 : low;
}

void Grid::Place(std::uint64_t position, StreamId stream, std::array<double, 4>& uniforms) const {
  const auto found = axes_of_.find(stream);
  if (found == axes_of_.end()) return;
  const std::uint64_t point = position % points_;
  for (std::size_t i = 0; i < found->second.count; ++i) {
    const Axis& axis = axes_[found->second.first + i];
    uniforms[i] = CentreOf(point / axis.stride % axis.levels, axis.levels, axis.split);
  }
}

std::string Grid::Text() const {
  std::string points =
      points_ == kMany ? "more than 10^19 points" : diag::Counted(points_, "point");
  if (axes_.size() < 2) return points;
  const auto levels = [](const Axis& axis) { return std::to_string(axis.levels); };
  return fmt::format("{} = {}", diag::Joined(axes_, " x ", levels), points);
}

}  // namespace mjforge::sample
