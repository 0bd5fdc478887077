// Latin hypercube sampling by pseudorandom permutations.

#include "mjforge/sample/latin.h"

#include <algorithm>

#include "mjforge/sample/permutation.h"
#include "mjforge/sample/philox.h"

namespace mjforge::sample {
namespace {

constexpr double kBelowOne = 1 - 0x1p-53;

}  // namespace

void PlaceLatin(const DrawKey& key, StreamId stream, std::uint64_t batch,
                std::array<double, 4>& uniforms) {
  const std::uint64_t position = key.index % batch;
  const auto keys = PhiloxWords(key.seed, key.index / batch, stream, 0, Purpose::kLatin);
  for (std::size_t i = 0; i < uniforms.size(); ++i) {
    const auto stratum = static_cast<double>(Permuted(position, batch, keys[i]));
    uniforms[i] = std::min((stratum + uniforms[i]) / static_cast<double>(batch), kBelowOne);
  }
}

}  // namespace mjforge::sample
