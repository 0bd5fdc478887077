// Pseudorandom permutation of 0 .. size - 1, computed without a table.

#pragma once

#include <cstdint>

namespace mjforge::sample {

/// Returns the image of `position` under a pseudorandom permutation of 0 .. size - 1; `key` selects
/// the permutation. The time is about the same for every size up to 2^63. Method: a Feistel network
/// on pairs of numbers below ceil(sqrt(size)), repeated until the result is below `size`. Source:
/// Black, Rogaway, "Ciphers with arbitrary finite domains", CT-RSA 2002 (generalized Feistel and
/// cycle walking).
std::uint64_t Permuted(std::uint64_t position, std::uint64_t size, std::uint64_t key);

}  // namespace mjforge::sample
