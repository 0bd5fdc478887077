// Sizes and points of grids.

#include "mjforge/sample/grid.h"

#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "loading.h"

namespace mjforge::sample {
namespace {

Sampler GridOf(const Family& family, std::uint64_t size) {
  return {*family.spec, Method::kGrid, 3, size};
}

std::string TextOf(const std::string& params, std::uint64_t size) {
  return GridOf(Load(params), size).GridText();
}

TEST_CASE("continuous dimensions share what the discrete ones leave") {
  CHECK(TextOf("{k: {choice: [a, b, c, d]}, x: 0 .. 1, y: 0 .. 1}", 100) ==
        "4 x 5 x 5 = 100 points");
  CHECK(TextOf("{x: 0 .. 1, y: 0 .. 1, z: 0 .. 1}", 100) == "5 x 5 x 4 = 100 points");
  CHECK(TextOf("{x: 0 .. 1, y: 0 .. 1}", 99) == "10 x 9 = 90 points");
  CHECK(TextOf("{x: 0 .. 1, b: {bernoulli: 0.5}}", 7) == "3 x 2 = 6 points");
  CHECK(TextOf("{x: 0 .. 1}", 1) == "1 point");
  CHECK(TextOf("{x: 3}", 10) == "1 point");
  CHECK(TextOf("{x: 0 .. 1}", kMaxBatch) == "4503599627370496 points");
}

TEST_CASE("more values than items are a grid that the batch begins") {
  const Family family = Load("{k: {choice: [a, b]}, n: {integer: [1, 9]}, x: 0 .. 1}");
  const Sampler grid = GridOf(family, 10);
  CHECK(grid.GridText() == "2 x 9 x 1 = 18 points");
  CHECK(grid.GridPoints() == 18);
  CHECK(TextOf("{a: {integer: [0, 1e15]}, b: {integer: [0, 1e15]}}", 10) ==
        "1000000000000001 x 1000000000000001 = more than 10^19 points");
}

TEST_CASE("other methods have no grid") {
  const Family family = Load("{x: 0 .. 1}");
  for (const Method method : {Method::kRandom, Method::kSobol, Method::kLatin}) {
    const Sampler sampler(*family.spec, method, 1, 10);
    CHECK(sampler.GridText().empty());
    CHECK(sampler.GridPoints() == 0);
  }
}

TEST_CASE("a grid has each combination once, the first parameter slowest, then begins anew") {
  Family family = Load("{k: {choice: [10, 20]}, x: 0 .. 1, n: {integer: [4, 6]}}");
  const Sampler grid = GridOf(family, 26);
  REQUIRE(grid.GridText() == "2 x 4 x 3 = 24 points");
  std::vector<std::array<double, 3>> points;
  for (const double k : {10.0, 20.0}) {
    for (const double x : {0.125, 0.375, 0.625, 0.875}) {
      for (const double n : {4.0, 5.0, 6.0}) points.push_back({k, x, n});
    }
  }
  for (std::uint64_t index = 0; index < 78; ++index) {
    const DrawKey key = {.seed = 3, .index = index};
    const std::array<double, 3> point = {family.Number("k", key, &grid),
                                         family.Number("x", key, &grid),
                                         family.Number("n", key, &grid)};
    CHECK(point == points[index % 26 % 24]);
  }
}

TEST_CASE("a coin has both sides however unfair it is") {
  Family family = Load("{a: {bernoulli: 0.01}, b: {bernoulli: 0.99}}");
  const Sampler grid = GridOf(family, 4);
  std::set<std::pair<bool, bool>> sides;
  for (std::uint64_t index = 0; index < 4; ++index) {
    const DrawKey key = {.seed = 3, .index = index};
    sides.emplace(std::get<bool>(family.Parameter("a", key, &grid)),
                  std::get<bool>(family.Parameter("b", key, &grid)));
  }
  CHECK(sides.size() == 4);
}

}  // namespace
}  // namespace mjforge::sample
