#pragma once

#include <array>
#include <cstdint>

#include "mjforge/sample/streams.h"

namespace mjforge::sample {

/// Divides (0, 1) into `batch` equal cells and moves each of a stream's uniforms into the cell of
/// this item in its block of `batch` items. For each number a pseudorandom permutation gives the
/// items their cells. Source: McKay, Beckman, Conover, "A comparison of three methods for selecting
/// values of input variables", Technometrics 21, 1979 (Latin hypercube sampling).
void PlaceLatin(const DrawKey& key, StreamId stream, std::uint64_t batch,
                std::array<double, 4>& uniforms);

}  // namespace mjforge::sample
