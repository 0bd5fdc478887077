#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "mjforge/sample/dimensions.h"

namespace mjforge::sample {

/// Sobol's sequence, scrambled by the seed; any point can be computed directly. Direction numbers
/// are those of Boost.Random (Joe, Kuo, "Constructing Sobol sequences with better two-dimensional
/// projections", SIAM J. Sci. Comput. 30, 2008). Nested uniform scrambling (Owen, "Randomly
/// permuted (t,m,s)-nets and (t,s)-sequences", 1995) whose bits are hashes of the digits before
/// them instead of being stored (Burley, "Practical hash-based Owen scrambling", JCGT 9, 2020). The
/// point 0 is kept (Owen, "On dropping the first Sobol' point", 2020).
class Sobol {
 public:
  /// Streams take dimensions in order. Streams beyond the last dimension with direction numbers are
  /// left out.
  Sobol(std::span<const DrawnStream> streams, std::uint64_t seed);

  /// Puts the stream's numbers of a point into `uniforms`, of the open interval (0, 1). For a
  /// stream without a dimension, `uniforms` stay unchanged.
  void Place(std::uint64_t index, StreamId stream, std::array<double, 4>& uniforms) const;

 private:
  struct Dimension {
    std::array<std::uint64_t, 64> directions;  // by bit of the index
    std::uint64_t key;                         // of the scrambling
  };
  struct Dimensions {
    std::size_t first;
    std::size_t count;
  };

  std::vector<Dimension> dimensions_;
  std::unordered_map<StreamId, Dimensions> dimensions_of_;
};

inline constexpr std::size_t kMostSobolDimensions = 3667;

}  // namespace mjforge::sample
