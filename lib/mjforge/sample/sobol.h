// Sobol's sequence with Owen scrambling.

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
/// projections", SIAM J. Sci. Comput. 30, 2008). The scrambling is nested and uniform (Owen,
/// "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995); its bits are not stored but hashed
/// from the leading bits (Burley, "Practical hash-based Owen scrambling", JCGT 9, 2020). Point 0 is
/// part of the sequence (Owen, "On dropping the first Sobol' point", 2020).
class Sobol {
 public:
  /// Assigns dimensions to the streams in order. Streams for which no direction numbers are left
  /// get no dimension.
  Sobol(std::span<const DrawnStream> streams, std::uint64_t seed);

  /// Replaces the uniforms of a stream by its coordinates of point `index`, in (0, 1). The uniforms
  /// of a stream without a dimension stay unchanged.
  void Place(std::uint64_t index, StreamId stream, std::array<double, 4>& uniforms) const;

 private:
  struct Dimension {
    std::array<std::uint64_t, 64> directions;  // by bit of the index
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
