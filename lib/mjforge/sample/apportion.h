// Apportionment: distributes a number of items according to weights, by largest remainders.

#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace mjforge::sample {

/// Distributes `total` items in proportion to the weights (Hamilton's method), and returns the
/// count of items for each weight. A weight gets its share rounded down, and the weights with the
/// largest remainders get one more item each. Among equal remainders, earlier weights come first.
/// Weights must be >= 0 and their sum positive; a weight of 0 gets no item. `total` is at most
/// 2^52.
std::vector<std::uint64_t> LargestRemainder(std::span<const double> weights, std::uint64_t total);

}  // namespace mjforge::sample
