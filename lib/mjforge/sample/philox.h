#pragma once

// The one generator behind all random numbers.

#include <array>
#include <cstdint>

#include <Random123/philox.h>

#include "mjforge/sample/streams.h"

namespace mjforge::sample {

/// The last word of the counter: numbers for different purposes are independent.
enum class Purpose : std::uint64_t { kDraw, kLatin, kScramble, kExact };

/// Philox4x64-10 with key (seed, 0) and counter (position, stream, attempt, purpose).
inline std::array<std::uint64_t, 4> PhiloxWords(std::uint64_t seed, std::uint64_t position,
                                                StreamId stream, std::uint64_t attempt,
                                                Purpose purpose) {
  using Philox = r123::Philox4x64;
  const Philox::ctr_type counter = {
      {position, stream, attempt, static_cast<std::uint64_t>(purpose)}};
  const Philox::key_type key = {{seed, 0}};
  const Philox::ctr_type words = Philox()(counter, key);
  return {words[0], words[1], words[2], words[3]};
}

/// The top 52 bits as a number of (0, 1), centred in their cell.
inline double UniformOf(std::uint64_t word) {
  return (static_cast<double>(word >> 12) + 0.5) * 0x1p-52;
}

/// A bijection of 64 bits that leaves no trace of regular input. Source: Steele, Lea,
/// Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014 (mix64variant13).
inline std::uint64_t Mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// 2^64 over the golden ratio, odd: spreads small numbers before Mix.
inline constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15;

}  // namespace mjforge::sample
