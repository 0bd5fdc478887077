// Pseudorandom permutations: bijective, uniform, without correlation of neighbours.

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "mjforge/sample/permutation.h"

namespace mjforge::sample {
namespace {

TEST_CASE("a permutation takes 0 .. size - 1 to themselves, each once") {
  for (std::uint64_t size = 1; size <= 300; ++size) {
    for (const std::uint64_t key : {std::uint64_t{0}, size * 7919, ~size}) {
      std::vector<bool> hit(size);
      for (std::uint64_t i = 0; i < size; ++i) {
        const std::uint64_t to = Permuted(i, size, key);
        REQUIRE(to < size);
        REQUIRE_FALSE(hit[to]);
        hit[to] = true;
      }
    }
  }
}

TEST_CASE("large permutations have no two positions at one place") {
  for (const std::uint64_t size : {std::uint64_t{1000000}, std::uint64_t{1} << 32,
                                   (std::uint64_t{1} << 52) - 1, std::uint64_t{1} << 63}) {
    std::set<std::uint64_t> hit;
    constexpr std::uint64_t kSamples = 20000;
    for (std::uint64_t i = 0; i < kSamples; ++i) {
      const std::uint64_t to = Permuted(size - 1 - i * (size / kSamples), size, 5);
      REQUIRE(to < size);
      hit.insert(to);
    }
    CHECK(hit.size() == kSamples);
  }
}

TEST_CASE("keys pick among all permutations alike") {
  constexpr int kKeys = 24000;
  std::map<std::vector<std::uint64_t>, int> counts;
  for (int key = 0; key < kKeys; ++key) {
    std::vector<std::uint64_t> order;
    for (std::uint64_t i = 0; i < 4; ++i) {
      order.push_back(Permuted(i, 4, static_cast<std::uint64_t>(key)));
    }
    ++counts[order];
  }
  REQUIRE(counts.size() == 24);
  double chi_square = 0;  // 23 degrees of freedom: 49.7 at the level of 0.001
  for (const auto& [order, count] : counts) chi_square += std::pow(count - 1000.0, 2) / 1000;
  CHECK(chi_square < 49.7);
}

TEST_CASE("where a position goes says nothing about where its neighbour goes") {
  constexpr std::uint64_t kSize = 10;
  constexpr int kKeys = 90000;
  std::map<std::pair<std::uint64_t, std::uint64_t>, int> counts;
  for (int key = 0; key < kKeys; ++key) {
    const auto k = static_cast<std::uint64_t>(key);
    ++counts[{Permuted(3, kSize, k), Permuted(4, kSize, k)}];
  }
  REQUIRE(counts.size() == 90);
  double chi_square = 0;  // 89 degrees of freedom: 135.98 at the level of 0.001
  for (const auto& [pair, count] : counts) chi_square += std::pow(count - 1000.0, 2) / 1000;
  CHECK(chi_square < 135.98);
}

}  // namespace
}  // namespace mjforge::sample
