#ifndef MJFORGE_SAMPLE_LATIN_H_
#define MJFORGE_SAMPLE_LATIN_H_

#include <array>
#include <cstdint>

#include "mjforge/sample/streams.h"

namespace mjforge::sample {

/// Moves each of a stream's uniforms into the N-th of (0, 1) that is this item's in its
/// block of `batch` items: a pseudorandom permutation of them for each number. Source:
/// McKay, Beckman, Conover, "A comparison of three methods for selecting values of input
/// variables", Technometrics 21, 1979 (Latin hypercube sampling).
void PlaceLatin(const DrawKey& key, StreamId stream, std::uint64_t batch,
                std::array<double, 4>& uniforms);

}  // namespace mjforge::sample

#endif  // MJFORGE_SAMPLE_LATIN_H_
