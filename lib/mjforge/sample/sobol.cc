// Sobol's sequence: direction numbers from Boost, hash-based Owen scrambling.

#include "mjforge/sample/sobol.h"

#include <bit>

#include <boost/random/sobol.hpp>

#include "mjforge/sample/philox.h"

namespace mjforge::sample {
namespace {

constexpr int kBits = 52;  // random bits of a uniform number

// Returns x after Owen scrambling: bit i, counted from the top, is flipped if the top bit of a hash
// of the i bits above bit i is set.
std::uint64_t Scrambled(std::uint64_t x, std::uint64_t key) {
  std::uint64_t flips = 0;
  for (int i = 0; i < kBits; ++i) {
    const std::uint64_t above = (x >> 1) >> (63 - i);
    // Number of the node of a binary tree to which the bits above bit i lead.
    const std::uint64_t node = (std::uint64_t{1} << i) | above;
    flips |= (Mix(key + node * kGoldenGamma) >> 63) << (63 - i);
  }
  return x ^ flips;
}

}  // namespace

Sobol::Sobol(std::span<const ParameterStream> streams, std::uint64_t seed) {
  for (const ParameterStream& stream : streams) {
    const auto count = static_cast<std::size_t>(stream.numbers);
    if (dimensions_.size() + count > kMostSobolDimensions) break;
    dimensions_of_.emplace(stream.stream, Dimensions{dimensions_.size(), count});
    const auto keys = PhiloxWords(seed, 0, stream.stream, 0, Purpose::kScramble);
    for (std::size_t i = 0; i < count; ++i) {
      dimensions_.push_back({.directions = {}, .key = keys[i]});
    }
  }
  if (dimensions_.empty()) return;
  // The engine of Boost returns points in the order of the Gray code. In this order, point 2^(j+1)
  // - 1 consists of the direction numbers of bit j. After seed(n), the engine returns point n + 1.
  boost::random::sobol engine(dimensions_.size());
  for (int bit = 0; bit < 64; ++bit) {
    engine.seed((~std::uint64_t{0} >> (63 - bit)) - 1);
    for (Dimension& dimension : dimensions_) {
      dimension.directions[static_cast<std::size_t>(bit)] = engine();
    }
  }
}

void Sobol::Place(std::uint64_t index, StreamId stream, std::array<double, 4>& uniforms) const {
  const auto found = dimensions_of_.find(stream);
  if (found == dimensions_of_.end()) return;
  for (std::size_t i = 0; i < found->second.count; ++i) {
    const Dimension& dimension = dimensions_[found->second.first + i];
    std::uint64_t x = 0;
    for (std::uint64_t rest = index; rest != 0; rest &= rest - 1) {
      x ^= dimension.directions[static_cast<std::size_t>(std::countr_zero(rest))];
    }
    uniforms[i] = UniformOf(Scrambled(x, dimension.key));
  }
}

}  // namespace mjforge::sample
