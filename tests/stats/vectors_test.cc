// Tests that rotations are uniform on SO(3) and directions uniform on the sphere.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "goodness.h"
#include "mjforge/sample/distributions.h"
#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

using std::numbers::pi;
constexpr std::uint64_t kVectors = 20000;

std::vector<std::array<double, 4>> Rotations() {
  std::vector<std::array<double, 4>> rotations;
  for (std::uint64_t i = 0; i < kVectors; ++i) {
    const auto u = Uniforms({.seed = 2, .index = i}, 6);
    rotations.push_back(UniformRotation(u[0], u[1], u[2]));
  }
  return rotations;
}

std::vector<std::array<double, 3>> Directions() {
  std::vector<std::array<double, 3>> directions;
  for (std::uint64_t i = 0; i < kVectors; ++i) {
    const auto u = Uniforms({.seed = 2, .index = i}, 6);
    directions.push_back(UniformDirection(u[0], u[1]));
  }
  return directions;
}

double UniformBelow(double x) { return (x + 1) / 2; }

TEST_CASE("the angle of a uniform rotation is distributed as (angle - sin angle) / pi") {
  std::vector<double> angles;
  for (const auto& q : Rotations()) angles.push_back(2 * std::acos(std::min(1.0, q[0])));
  CHECK(KolmogorovSmirnov(angles, [](double angle) { return (angle - std::sin(angle)) / pi; }) >
        kLevel);
}

TEST_CASE("the axis of a uniform rotation is uniform on the sphere") {
  for (std::size_t axis = 1; axis < 4; ++axis) {
    std::vector<double> components;
    for (const auto& q : Rotations()) {
      components.push_back(q[axis] / std::sqrt(1 - q[0] * q[0]));
    }
    CHECK(KolmogorovSmirnov(components, UniformBelow) > kLevel);
  }
}

TEST_CASE("a uniform rotation takes each axis to a uniform direction") {
  std::vector<double> xx;
  std::vector<double> yz;
  std::vector<double> zz;
  for (const auto& [w, x, y, z] : Rotations()) {
    xx.push_back(1 - 2 * (y * y + z * z));
    yz.push_back(2 * (y * z + w * x));
    zz.push_back(1 - 2 * (x * x + y * y));
  }
  CHECK(KolmogorovSmirnov(xx, UniformBelow) > kLevel);
  CHECK(KolmogorovSmirnov(yz, UniformBelow) > kLevel);
  CHECK(KolmogorovSmirnov(zz, UniformBelow) > kLevel);
}

TEST_CASE("each component of a uniform direction is uniform (Archimedes)") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> components;
    for (const auto& direction : Directions()) components.push_back(direction[axis]);
    CHECK(KolmogorovSmirnov(components, UniformBelow) > kLevel);
    CHECK(std::abs(MomentsOf(components).mean) < 5 / std::sqrt(3.0 * kVectors));
  }
}

TEST_CASE("uniform directions fall into each octant alike") {
  std::vector<double> counts(8);
  for (const auto& [x, y, z] : Directions()) {
    counts[(x > 0 ? 4u : 0u) + (y > 0 ? 2u : 0u) + (z > 0 ? 1u : 0u)] += 1;
  }
  CHECK(ChiSquare(counts, std::vector<double>(8, kVectors / 8.0)) > kLevel);
}

}  // namespace
}  // namespace mjforge::sample
