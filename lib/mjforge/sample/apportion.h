#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace mjforge::sample {

/// How many of `total` items each weight gets: its share rounded down, and one more
/// for the largest remainders (Hamilton's method), ties to the first. Weights are
/// >= 0 with a positive sum; a weight of 0 gets none. total <= 2^52.
std::vector<std::uint64_t> LargestRemainder(std::span<const double> weights, std::uint64_t total);

}  // namespace mjforge::sample
