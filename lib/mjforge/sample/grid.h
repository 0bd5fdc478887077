// Grid sampling: a full factorial design over the parameters.

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

/// A full factorial design: every combination of the levels of all dimensions; the first dimension
/// varies slowest. A discrete dimension has one level per value. The other dimensions get equal
/// numbers of levels, so that the grid has at most `size` points if possible; the first ones get
/// one more level if the grid stays within `size`.
class Grid {
 public:
  Grid(std::span<const DrawnStream> streams, std::uint64_t size);

  /// Replaces the uniforms of a stream by its coordinates of the point at `position`, the centres
  /// of cells. Positions past the last point start over. The uniforms of a stream outside the grid
  /// stay unchanged.
  void Place(std::uint64_t position, StreamId stream, std::array<double, 4>& uniforms) const;

  /// Returns the number of points, at most 2^64 - 1.
  std::uint64_t points() const { return points_; }
  /// Returns "4 x 5 x 5 = 100 points".
  std::string Text() const;

 private:
  struct Axis {
    std::uint64_t levels;         // at least 1
    std::uint64_t stride;         // difference of position from one level to the next
    std::optional<double> split;  // DrawnStream::split
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
