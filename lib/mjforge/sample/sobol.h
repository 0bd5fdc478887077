// Sobol's sequence with Owen scrambling.

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "mjforge/sample/dimensions.h"

namespace mjforge::sample {

/// Sobol's sequence, scrambled by the seed. Any point can be computed directly. Direction numbers
/// are those of Boost.Random (Joe, Kuo, "Constructing Sobol sequences with better two-dimensional
/// projections", SIAM J. Sci. Comput. 30, 2008). The scrambling is nested and uniform (Owen,
/// "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995). Its bits are not stored, but are
/// hashes of the leading bits (Burley, "Practical hash-based Owen scrambling", JCGT 9, 2020). The
/// sequence contains point 0 (Owen, "On dropping the first Sobol' point", 2020).
class Sobol {
 public:
  /// Assigns dimensions to the streams, in order. Streams for which Boost.Random has no more
  /// direction numbers get no dimension.
  Sobol(std::span<const ParameterStream> streams, std::uint64_t seed);

  /// Replaces the uniform numbers of a stream by the coordinates, in (0, 1), of point `index` in
  /// the dimensions of the stream. Does not change the uniform numbers of a stream without a
  /// dimension.
  void Place(std::uint64_t index, StreamId stream, std::array<double, 4>& uniforms) const;

 private:
  struct Dimension {
    std::array<std::uint64_t, 64> directions;  // direction number for each bit of the index
    std::uint64_t key;                         // scrambling key
  };
  struct Dimensions {
    std::size_t first;
    std::size_t count;
  };

  std::vector<Dimension> dimensions_;
  std::unordered_map<StreamId, Dimensions> dimensions_of_;
};

/// Number of dimensions for which Boost.Random has direction numbers.
inline constexpr std::size_t kMostSobolDimensions = 3667;

}  // namespace mjforge::sample
