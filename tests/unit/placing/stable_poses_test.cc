// Stable poses of simple bodies, in closed form.
#include "mjforge/placing/stable_poses.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "mjforge/placing/body_shapes.h"
#include "scene.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector3d;
using model::GeomType;
using model::StablePose;

std::vector<std::string> NamesOf(const std::vector<StablePose>& poses) {
  std::vector<std::string> names;
  for (const StablePose& pose : poses) names.push_back(pose.name);
  return names;
}

using Names = std::vector<std::string>;

TEST_CASE("a box stands on each of its faces, most probably on the largest") {
  Scene scene;
  const int box = scene.Add(ShapeOf(GeomType::kBox, 0.1, 0.2, 0.3));
  const std::vector<StablePose> poses = StablePosesOf(scene.object, box, 0);
  CHECK(NamesOf(poses) ==
        Names{"on_right", "on_left", "on_front", "on_back", "upright", "upside_down"});
  CHECK(poses[0].margin == Approx(std::atan(0.2 / 0.1)));
  CHECK(poses[4].margin == Approx(std::atan(0.1 / 0.3)));
  CHECK(poses[4].rotation.isApprox(Eigen::Quaterniond::Identity()));
  // The solid angle of a rectangle seen from above its middle: 4 asin(a b / sqrt(...)).
  const double share = 4 * std::asin(0.02 / std::sqrt((0.01 + 0.09) * (0.04 + 0.09))) / (4 * M_PI);
  CHECK(poses[4].probability == Approx(share));
  double sum = 0;
  for (const StablePose& pose : poses) sum += pose.probability;
  CHECK(sum == Approx(1));
  // The named side is down: with the front at -y, the right is -x.
  CHECK((poses[0].rotation * -Vector3d::UnitX() + Vector3d::UnitZ()).norm() < 1e-9);
  CHECK((poses[2].rotation * -Vector3d::UnitY() + Vector3d::UnitZ()).norm() < 1e-9);
}

TEST_CASE("sides are named after the front") {
  Scene scene;
  const int box = scene.Add(ShapeOf(GeomType::kBox, 0.1, 0.2, 0.3));
  const std::vector<StablePose> poses = StablePosesOf(scene.object, box, M_PI / 2);
  CHECK(poses[0].name == "on_front");
  CHECK((poses[0].rotation * Vector3d::UnitX() + Vector3d::UnitZ()).norm() < 1e-9);
}

TEST_CASE("round sides are one pose") {
  Scene scene;
  const int can = scene.Add(ShapeOf(GeomType::kCylinder, 0.03, 0.06));
  const std::vector<StablePose> poses = StablePosesOf(scene.object, can, 0);
  CHECK(NamesOf(poses) == Names{"on_front", "upright", "upside_down"});
  CHECK(poses[0].margin == Approx(std::atan(0.06 / 0.03)).epsilon(2e-3));
  CHECK(poses[1].margin == Approx(std::atan(0.03 / 0.06)).epsilon(2e-3));
  const int ball = scene.Add(ShapeOf(GeomType::kSphere, 0.03));
  const std::vector<StablePose> any = StablePosesOf(scene.object, ball, 0);
  REQUIRE(any.size() == 1);
  CHECK(any[0].margin == Approx(M_PI));
  CHECK(any[0].probability == Approx(1));
  const int pill = scene.Add(ShapeOf(GeomType::kCapsule, 0.03, 0.06));
  CHECK(NamesOf(StablePosesOf(scene.object, pill, 0)) == Names{"on_front"});
}

TEST_CASE("a body does not stand on a face that its centre of mass is not above") {
  Scene scene;
  // A post with a heavy arm that reaches beyond its foot.
  const int gallows = scene.Add(ShapeOf(GeomType::kBox, 0.01, 0.01, 0.1));
  scene.AddPart(ShapeOf(GeomType::kBox, 0.1, 0.01, 0.01), At(0.09, 0, 0.11));
  const Names names = NamesOf(StablePosesOf(scene.object, gallows, 0));
  CHECK(std::ranges::find(names, "upright") == names.end());
  CHECK(std::ranges::find(names, "on_front") != names.end());
  CHECK(std::ranges::find(names, "upside_down") != names.end());
}

TEST_CASE("legs of slightly different length are one foot") {
  Scene scene;
  const int table = scene.Add(ShapeOf(GeomType::kBox, 0.3, 0.2, 0.01), At(0, 0, 0));
  int i = 0;
  for (const double x : {-0.29, 0.29}) {
    for (const double y : {-0.19, 0.19})
      scene.AddPart(ShapeOf(GeomType::kBox, 0.01, 0.01, 0.1), At(x, y, -0.11 - 1e-9 * i++));
  }
  const std::vector<StablePose> poses = StablePosesOf(scene.object, table, 0);
  const auto upright = std::ranges::find(poses, "upright", &StablePose::name);
  REQUIRE(upright != poses.end());
  const Vector3d center = MassBelow(scene.object, table).p_FCm;
  CHECK(upright->margin == Approx(std::atan(0.2 / (0.21 + center.z()))).epsilon(1e-4));
}

TEST_CASE("a body does not rest on an edge and a point of a round rim") {
  Scene scene;
  // A head, and a shank whose rim would roll away under the centre of mass.
  const int peg = scene.Add(ShapeOf(GeomType::kBox, 0.02, 0.02, 0.01));
  scene.AddPart(ShapeOf(GeomType::kCylinder, 0.008, 0.05), At(0, 0, -0.05));
  CHECK(NamesOf(StablePosesOf(scene.object, peg, 0)) ==
        Names{"on_front", "on_back", "on_right", "on_left", "upside_down", "upright"});
}

TEST_CASE("a pose is exact where a round part touches the ground") {
  Scene scene;
  const int hammer = scene.Add(ShapeOf(GeomType::kBox, 0.05, 0.02, 0.02), At(0, 0, 0));
  scene.AddPart(ShapeOf(GeomType::kCylinder, 0.012, 0.1), At(0, 0, -0.12));
  const std::vector<StablePose> poses = StablePosesOf(scene.object, hammer, 0);
  const auto front = std::ranges::find(poses, "on_front", &StablePose::name);
  REQUIRE(front != poses.end());
  // The head's edge, which is 20 mm from the axis of the handle, and the handle's end, 12 mm from
  // the axis, are 200 mm apart along it.
  const Vector3d axis = front->rotation * Vector3d::UnitZ();
  CHECK(axis.z() == Approx(std::sin(std::atan(0.008 / 0.2))).margin(1e-7));
}

TEST_CASE("a body without volume has no stable pose") {
  Scene scene;
  scene.object.bodies.emplace_back();
  CHECK(StablePosesOf(scene.object, 0, 0).empty());
}

}  // namespace
}  // namespace mjforge::placing
