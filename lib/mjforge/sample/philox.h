// Philox, the counter-based generator of all random numbers, and a 64-bit hash.

#pragma once

#include <array>
#include <cstdint>

#include <Random123/philox.h>

#include "mjforge/sample/streams.h"

namespace mjforge::sample {

/// Use of a random number: the last word of the counter of Philox. Numbers for different purposes
/// are independent of each other.
enum class Purpose : std::uint64_t { kDraw, kLatin, kScramble, kExact };

/// Returns a block of Philox4x64-10 with key (seed, 0) and counter (position, stream, attempt,
/// purpose).
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

/// Returns the top 52 bits of a word as a number in (0, 1): the centre of one of 2^52 equal cells.
inline double UniformOf(std::uint64_t word) {
  return (static_cast<double>(word >> 12) + 0.5) * 0x1p-52;
}

/// A bijective hash of 64 bits. Source: Steele, Lea, Flood, "Fast splittable pseudorandom number
/// generators", OOPSLA 2014 (mix64variant13).
inline std::uint64_t Mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// 2^64 divided by the golden ratio, rounded to an odd number. The product of a small number, such
/// as an index, and this constant is a better input of Mix(), because the product is spread over
/// all 64 bits.
inline constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15;

}  // namespace mjforge::sample
