// Pseudorandom permutation by a Feistel network with cycle walking.

#include "mjforge/sample/permutation.h"

#include <cmath>

#include "mjforge/sample/philox.h"

namespace mjforge::sample {
namespace {

// Number of rounds of the Feistel network. Four rounds make a strong pseudorandom permutation of a
// large domain. A small domain needs more rounds to make all permutations about equally likely.
constexpr std::uint64_t kRounds = 8;

std::uint64_t RootRoundedUp(std::uint64_t size) {
  auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(size)));
  while (root > 1 && (root - 1) * (root - 1) >= size) --root;
  while (root * root < size) ++root;
  return root;
}

// Maps a hash to 0 .. bound - 1; `bound` is at most 2^32.
std::uint64_t Below(std::uint64_t bound, std::uint64_t hash) {
  return ((hash >> 32) * bound) >> 32;
}

}  // namespace

std::uint64_t Permuted(std::uint64_t position, std::uint64_t size, std::uint64_t key) {
  if (size < 2) return position;
  const std::uint64_t side = RootRoundedUp(size);
  do {
    std::uint64_t left = position / side;
    std::uint64_t right = position % side;
    for (std::uint64_t round = 0; round < kRounds; ++round) {
      // right * kRounds + round is below 2^35 and different for each pair (right, round).
      // Therefore, all inputs of the hash are different.
      const std::uint64_t input = key + (right * kRounds + round + 1) * kGoldenGamma;
      std::uint64_t next = left + Below(side, Mix(input));
      if (next >= side) next -= side;
      left = right;
      right = next;
    }
    position = left * side + right;
  } while (position >= size);
  return position;
}

}  // namespace mjforge::sample
