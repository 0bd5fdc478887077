// Tests of poses and MJCF's orientations.

#include "mjforge/model/poses.h"

#include <cmath>

#include <catch2/catch.hpp>

namespace mjforge::model {
namespace {

using Eigen::Vector3d;

bool Near(const Vector3d& a, const Vector3d& b) { return (a - b).norm() < 1e-14; }

TEST_CASE("euler angles turn about the moving axes") {
  const Eigen::Quaterniond q = FromEuler({M_PI / 2, M_PI / 2, 0});
  // The first turn takes y to z, the second is about the new y, which points up.
  CHECK(Near(q * Vector3d::UnitX(), {0, 1, 0}));
  CHECK(Near(q * Vector3d::UnitY(), {0, 0, 1}));
}

TEST_CASE("the axis of an angle may have any length") {
  const Eigen::Quaterniond q = FromAxisAngle({0, 0, 1e-200}, M_PI / 2);
  CHECK(Near(q * Vector3d::UnitX(), {0, 1, 0}));
}

TEST_CASE("xyaxes keeps the x axis and turns y into its plane") {
  const Eigen::Quaterniond q = FromXyAxes({0, 2, 0}, {-3, 1, 0});
  CHECK(Near(q * Vector3d::UnitX(), {0, 1, 0}));
  CHECK(Near(q * Vector3d::UnitY(), {-1, 0, 0}));
  CHECK(Near(q * Vector3d::UnitZ(), {0, 0, 1}));
}

TEST_CASE("zaxis turns z by the smallest rotation") {
  const Vector3d z = Vector3d(1, 2, 3).normalized();
  const Eigen::Quaterniond q = FromZAxis({1, 2, 3});
  CHECK(Near(q * Vector3d::UnitZ(), z));
  CHECK(std::abs(q.vec().dot(z) - 0) < 1e-14);
  CHECK(q.w() == Approx(std::cos(std::acos(z.z()) / 2)).epsilon(1e-14));
}

TEST_CASE("zaxis straight down is a half turn about x") {
  const Eigen::Quaterniond q = FromZAxis({0, 0, -2});
  CHECK(Near(q * Vector3d::UnitZ(), {0, 0, -1}));
  CHECK(Near(q * Vector3d::UnitX(), {1, 0, 0}));
}

TEST_CASE("a pose times its inverse is the identity") {
  const Pose X_AB = {.p = {1, 2, 3}, .q = FromEuler({0.1, 0.2, 0.3})};
  const Pose X_BB = X_AB.Inverse() * X_AB;
  CHECK(Near(X_BB.p, Vector3d::Zero()));
  CHECK(Near(X_BB.q * Vector3d(1, 2, 3), {1, 2, 3}));
}

}  // namespace
}  // namespace mjforge::model
