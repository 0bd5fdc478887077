#pragma once

#include <cstdint>

namespace mjforge::sample {

/// Where a pseudorandom permutation of 0 .. size - 1 takes `position`; the key picks
/// the permutation. Needs no memory and about the same time for every size up to 2^63.
/// A Feistel network on pairs of numbers below ceil(sqrt(size)), walked until the
/// result is in range. Source: Black, Rogaway, "Ciphers with arbitrary finite
/// domains", CT-RSA 2002 (generalized Feistel and cycle walking).
std::uint64_t Permuted(std::uint64_t position, std::uint64_t size, std::uint64_t key);

}  // namespace mjforge::sample
