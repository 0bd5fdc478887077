// Apportionment by largest remainders, with a tolerance for rounding errors of the shares.

#include "mjforge/sample/apportion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace mjforge::sample {
namespace {

// Remainders are rounded to multiples of this step, because shares have rounding errors: equal
// remainders must compare equal, and a share of 2.9999999 must be treated as 3.
constexpr double kRemainderStep = 0x1p-20;

}  // namespace

std::vector<std::uint64_t> LargestRemainder(std::span<const double> weights, std::uint64_t total) {
  const double largest = *std::ranges::max_element(weights);
  double sum = 0;  // sum of weight / largest over all weights; cannot overflow
  for (const double weight : weights) sum += weight / largest;
  std::vector<std::uint64_t> counts;
  std::vector<double> remainders;
  std::uint64_t left = total;
  for (const double weight : weights) {
    const double share = static_cast<double>(total) * (weight / largest / sum);
    const std::uint64_t whole = std::min(static_cast<std::uint64_t>(share), left);
    counts.push_back(whole);
    left -= whole;
    const double remainder = share - static_cast<double>(whole);
    remainders.push_back(std::round(remainder / kRemainderStep) * kRemainderStep);
  }
  std::vector<std::size_t> order(weights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return weights[i] == 0; });
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return remainders[a] > remainders[b]; });
  // Gives the remaining items to the weights, one each, from the largest remainder. A second round
  // is necessary only if rounding errors of a huge total leave more items than there are weights.
  for (std::size_t i = 0; left > 0; i = (i + 1) % order.size(), --left) ++counts[order[i]];
  return counts;
}

}  // namespace mjforge::sample
