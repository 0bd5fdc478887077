// Tests of joints, their defaults and ranges.

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

const std::string kBall = "parts: [{name: a, type: sphere, size: [1]}]\n";

TEST_CASE("an object is free to move unless it says otherwise") {
  const Assembling free(kBall);
  REQUIRE(free.body().joints.size() == 1);
  CHECK(free.body().joints[0].type == "free");
  CHECK(Assembling(kBall + "joints: none\n").body().joints.empty());
}

TEST_CASE("joints are hinges about z unless they say otherwise") {
  const Assembling thing(
      kBall +
      "joints:\n"
      "- {name: h, damping: 0.1}\n"
      "- {name: s, type: slide, axis: [0, 3, 4], pos: [1, 2, 3], range: [-1, 2]}\n"
      "- {name: u, range: [0, 1], limited: false}\n");
  const std::vector<model::Joint>& joints = thing.body().joints;
  REQUIRE(joints.size() == 3);
  CHECK(joints[0].name == "thing_h");
  CHECK(joints[0].type == "hinge");
  CHECK(joints[0].axis == Eigen::Vector3d::UnitZ());
  CHECK_FALSE(joints[0].range);
  CHECK(model::FindAttribute(joints[0].attributes, "damping")->numbers == sample::Numbers{0.1});
  CHECK(joints[1].axis.isApprox(Eigen::Vector3d(0, 0.6, 0.8)));
  CHECK(joints[1].range == Eigen::Vector2d(-1, 2));
  CHECK(joints[1].pos == Eigen::Vector3d(1, 2, 3));
  CHECK_FALSE(joints[2].range);
}

TEST_CASE("limits that MuJoCo would refuse are refused with their numbers") {
  const auto finding = [](const std::string& fields) {
    return OnlyFinding(kBall + "joints: [{name: j, " + fields + "}]\n");
  };
  CHECK(finding("range: [2, 1]") ==
        "4:27 range of joint 'j' is 2 .. 1; it must go from a smaller to a larger number");
  CHECK(finding("type: ball, range: [1, 2]") ==
        "4:39 range of joint 'j' is 1 .. 2; it must begin with 0 for a ball joint");
  CHECK(finding("type: free, range: [1, 2]") ==
        "4:39 range of joint 'j' is 1 .. 2; it has no meaning for a free joint");
  CHECK(finding("limited: true") == "4:29 limited of joint 'j' is true, but it has no range");
}

TEST_CASE("a free joint stands alone") {
  CHECK(OnlyFinding(kBall + "joints: [{name: h}, {name: f, type: free}]\n") ==
        "4:21 free joint 'thing_f' is not the only joint of its body (a free joint already allows "
        "every motion)");
}

}  // namespace
}  // namespace mjforge::assemble
