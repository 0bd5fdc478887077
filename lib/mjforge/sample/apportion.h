// Apportionment of a number of items to weights, by largest remainders.

#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace mjforge::sample {

/// Returns the number of items, out of `total`, for each weight: its share rounded down, and one
/// more for the largest remainders (Hamilton's method); of equal remainders the first ones win.
/// Weights are >= 0 with a positive sum; a weight of 0 gets no item. total <= 2^52.
std::vector<std::uint64_t> LargestRemainder(std::span<const double> weights, std::uint64_t total);

}  // namespace mjforge::sample
