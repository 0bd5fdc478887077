// Mass that overlapping parts count twice.
#include "mjforge/static_checks/mass_overlap.h"

#include <catch2/catch.hpp>
#include <vector>

namespace mjforge::static_checks {
namespace {

model::Part Cube(double half, double density) {
  model::Part cube;
  cube.shape = {model::GeomType::kBox, Eigen::Vector3d::Constant(half), nullptr};
  cube.mass = density * model::Volume(cube.shape);
  return cube;
}

model::Pose At(double x) {
  model::Pose pose;
  pose.p = Eigen::Vector3d(x, 0, 0);
  return pose;
}

TEST_CASE("mass counted twice is found to a hundredth") {
  // Half of the second cube is inside the first; the third is inside both.
  const model::Part first = Cube(0.1, 1000);
  const model::Part second = Cube(0.1, 500);
  const model::Part third = Cube(0.02, 2000);
  const std::vector<PlacedPart> parts = {{&first, At(0)}, {&second, At(0.1)}, {&third, At(0.05)}};
  const Overlap overlap = FindOverlap(parts);
  CHECK(overlap.mass == Approx(4.0 / 2 + 0.128).margin(0.01 * (4.0 + 0.128)));
  CHECK(overlap.first == 0);
  CHECK(overlap.second == 1);
}

TEST_CASE("parts that meet at a face share nothing") {
  const model::Part cube = Cube(0.1, 1000);
  const std::vector<PlacedPart> parts = {{&cube, At(0)}, {&cube, At(0.2)}};
  CHECK(FindOverlap(parts).mass == 0);
}

}  // namespace
}  // namespace mjforge::static_checks
