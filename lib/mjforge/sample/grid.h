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

/// A full factorial design: every combination of the levels of all dimensions, where the first
/// dimension varies slowest. A discrete dimension has one level per value. All other dimensions
/// have the same number of levels, at least 1: the largest for which the grid has at most `size`
/// points. Then the first of these dimensions get one level more, as many as the limit of `size`
/// points allows.
class Grid {
 public:
  Grid(std::span<const ParameterStream> streams, std::uint64_t size);

  /// Replaces the uniform numbers of a stream by the coordinates of the grid point `position` in
  /// the dimensions of the stream. The coordinates are centres of cells of (0, 1). Positions beyond
  /// the last point start again with the first point. Does not change the uniform numbers of a
  /// stream that has no dimension in the grid.
  void Place(std::uint64_t position, StreamId stream, std::array<double, 4>& uniforms) const;

  /// Returns the number of points of the grid; 2^64 - 1 if there are more.
  std::uint64_t points() const { return points_; }
  /// Returns the size of the grid as text: "4 x 5 x 5 = 100 points".
  std::string Text() const;

 private:
  struct Axis {
    std::uint64_t levels;         // at least 1
    std::uint64_t stride;         // difference of `position` between neighbouring levels
    std::optional<double> split;  // see ParameterStream::split
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
