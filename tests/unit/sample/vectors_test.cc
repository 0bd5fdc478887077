// Colours, rotations and directions at known points.

#include <catch2/catch.hpp>
#include <cmath>

#include "mjforge/sample/distributions.h"

namespace mjforge::sample {
namespace {

using Catch::Matchers::WithinAbs;
using Triple = std::array<double, 3>;

void CheckNear(const Triple& actual, const Triple& expected) {
  for (std::size_t i = 0; i < 3; ++i) CHECK_THAT(actual[i], WithinAbs(expected[i], 1e-15));
}

TEST_CASE("hue goes round from red to red") {
  CheckNear(HsvToRgb(0, 1, 1), {1, 0, 0});
  CheckNear(HsvToRgb(1.0 / 6, 1, 1), {1, 1, 0});
  CheckNear(HsvToRgb(2.0 / 6, 1, 1), {0, 1, 0});
  CheckNear(HsvToRgb(3.0 / 6, 1, 1), {0, 1, 1});
  CheckNear(HsvToRgb(4.0 / 6, 1, 1), {0, 0, 1});
  CheckNear(HsvToRgb(5.0 / 6, 1, 1), {1, 0, 1});
  CheckNear(HsvToRgb(1, 1, 1), {1, 0, 0});
}

TEST_CASE("a colour without saturation is grey, without value black") {
  CheckNear(HsvToRgb(0.37, 0, 0.6), {0.6, 0.6, 0.6});
  CheckNear(HsvToRgb(0.37, 0.8, 0), {0, 0, 0});
}

TEST_CASE("a colour between two corners is linear in hue") {
  CheckNear(HsvToRgb(0.25 / 6, 0.5, 0.8), {0.8, 0.5, 0.4});
  CheckNear(HsvToRgb(1.25 / 6, 0.5, 0.8), {0.7, 0.8, 0.4});
  CheckNear(HsvToRgb(5.25 / 6, 0.5, 0.8), {0.8, 0.4, 0.7});
}

TEST_CASE("a drawn rotation is a unit quaternion with w not negative") {
  for (const double u0 : {0x1p-53, 0.2, 0.5, 0.9, 1 - 0x1p-53}) {
    for (const double u1 : {0x1p-53, 0.3, 0.6, 1 - 0x1p-53}) {
      for (const double u2 : {0.1, 0.4, 0.7, 0.95}) {
        const auto q = UniformRotation(u0, u1, u2);
        CHECK_THAT(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], WithinAbs(1, 1e-15));
        CHECK(q[0] >= 0);
      }
    }
  }
}

TEST_CASE("a drawn direction is a unit vector whose height is uniform") {
  for (const double u0 : {0x1p-53, 0.2, 0.5, 0.9, 1 - 0x1p-53}) {
    for (const double u1 : {0x1p-53, 0.3, 0.6, 1 - 0x1p-53}) {
      const Triple d = UniformDirection(u0, u1);
      CHECK_THAT(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], WithinAbs(1, 1e-15));
      CHECK(d[2] == 2 * u0 - 1);
    }
  }
}

}  // namespace
}  // namespace mjforge::sample
