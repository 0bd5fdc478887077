// Latin hypercube sampling.

#pragma once

#include <array>
#include <cstdint>

#include "mjforge/sample/streams.h"

namespace mjforge::sample {

/// Divides (0, 1) into `batch` equal cells, and moves each uniform number of a stream into one of
/// the cells. In every block of `batch` items, each cell contains the number of exactly one item.
/// For each uniform number of the stream, a pseudorandom permutation assigns cells to items.
/// Source: McKay, Beckman, Conover, "A comparison of three methods for selecting values of input
/// variables", Technometrics 21, 1979 (Latin hypercube sampling).
void PlaceLatin(const DrawKey& key, StreamId stream, std::uint64_t batch,
                std::array<double, 4>& uniforms);

}  // namespace mjforge::sample
