// Latin hypercube sampling.

#pragma once

#include <array>
#include <cstdint>

#include "mjforge/sample/streams.h"

namespace mjforge::sample {

/// Divides (0, 1) into `batch` equal cells and moves each of a stream's uniforms into one of the
/// cells, so that each cell has one item of every block of `batch` items. A pseudorandom
/// permutation for each of the uniforms assigns the cells. Source: McKay, Beckman, Conover, "A
/// comparison of three methods for selecting values of input variables", Technometrics 21, 1979
/// (Latin hypercube sampling).
void PlaceLatin(const DrawKey& key, StreamId stream, std::uint64_t batch,
                std::array<double, 4>& uniforms);

}  // namespace mjforge::sample
