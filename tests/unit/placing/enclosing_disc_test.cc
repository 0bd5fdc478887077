// Smallest enclosing discs.
#include "mjforge/placing/enclosing_disc.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "harness/effort.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector2d;

double ReachOf(const std::vector<Disc>& discs, const Vector2d& from) {
  double reach = 0;
  for (const Disc& disc : discs) reach = std::max(reach, (disc.center - from).norm() + disc.radius);
  return reach;
}

TEST_CASE("the smallest disc around few discs has a closed form") {
  const auto check = [](const std::vector<Disc>& discs, const Vector2d& center, double radius) {
    const Disc around = EnclosingDisc(discs);
    CHECK((around.center - center).norm() < 1e-12);
    CHECK(std::abs(around.radius - radius) < 1e-12);
  };
  check({{{1, 2}, 0}}, {1, 2}, 0);
  check({{{1, 2}, 3}}, {1, 2}, 3);
  check({{{-1, 0}, 0}, {{3, 0}, 0}}, {1, 0}, 2);
  check({{{-1, 0}, 1}, {{3, 0}, 3}}, {2, 0}, 4);
  check({{{0, 0}, 5}, {{1, 1}, 1}}, {0, 0}, 5);
  // Rectangle; regular triangle of equal discs; three discs in a row.
  check({{{-3, -4}, 0}, {{3, -4}, 0}, {{3, 4}, 0}, {{-3, 4}, 0}}, {0, 0}, 5);
  const double h = std::sqrt(3) / 2;
  check({{{1, 0}, 0.5}, {{-0.5, h}, 0.5}, {{-0.5, -h}, 0.5}}, {0, 0}, 1.5);
  check({{{-2, 0}, 1}, {{0, 0}, 1}, {{2, 0}, 1}}, {0, 0}, 3);
}

TEST_CASE("no disc around random discs is smaller than the smallest one") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < harness::Effort(200); ++i) {
    std::vector<Disc> discs(1 + random() % 40);
    for (Disc& disc : discs) {
      disc.center = {uniform(random), uniform(random)};
      disc.radius = i % 2 == 0 ? 0 : 0.3 * std::abs(uniform(random));
    }
    const Disc around = EnclosingDisc(discs);
    CHECK(ReachOf(discs, around.center) <= around.radius + 1e-12);
    // The reach is a convex function of the centre, so that a local minimum is the smallest.
    for (int j = 0; j < 32; ++j) {
      const double angle = 2 * M_PI * j / 32;
      const Vector2d near = around.center + 1e-4 * Vector2d(std::cos(angle), std::sin(angle));
      CHECK(ReachOf(discs, near) >= around.radius - 1e-12);
    }
  }
}

}  // namespace
}  // namespace mjforge::placing
