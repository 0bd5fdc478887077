#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "mjforge/sample/dimensions.h"

namespace mjforge::sample {

/// A full factorial: every combination of the levels of all dimensions, the first dimension varying
/// slowest. Discrete dimensions have as many levels as values; the others share what remains of
/// `size` as equally as possible; the first ones may get one level more.
class Grid {
 public:
  Grid(std::span<const DrawnStream> streams, std::uint64_t size);

  /// Puts the stream's numbers of the point at `position` into `uniforms`: centres of their cells.
  /// Positions past the last point start over. For a stream outside the grid, `uniforms` stay
  /// unchanged.
  void Place(std::uint64_t position, StreamId stream, std::array<double, 4>& uniforms) const;

  /// The number of points, at most 2^64 - 1.
  std::uint64_t points() const { return points_; }
  /// "4 x 5 x 5 = 100 points".
  std::string Text() const;

 private:
  struct Axis {
    std::uint64_t levels;         // at least 1
    std::uint64_t stride;         // points from one level to the next
    std::optional<double> split;  // as DrawnStream::split
  };
  struct Axes {
    std::size_t first;
    std::size_t count;
  };
  void ShareLevels(std::uint64_t size);

  std::vector<Axis> axes_;
  std::unordered_map<StreamId, Axes> axes_of_;
  std::uint64_t points_ = 1;
};

}  // namespace mjforge::sample
