// Grasp tests: which objects a gripper can hold.
#include <Eigen/Dense>

#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

model::Checks Grasped(double force = 30, double width = 0.08) {
  model::Checks checks;
  checks.grasps = model::GraspingCheck{.width = width, .force = force};
  return checks;
}

std::string Cube(double half_side, const std::string& more = {}) {
  const std::string side = std::to_string(half_side);
  return Free(0.2, "<geom type=\"box\" size=\"" + side + " " + side + " " + side +
                       "\" mass=\"1\"/>" + more);
}

}  // namespace

TEST_CASE("jaws hold what their friction carries, and no more") {
  // 1 kg, lifted at 1.5 g, is carried by two faces with friction 1: above 4.9 N at rest.
  const Examined held = Examine(Cube(0.02), {}, Grasped(12));
  CHECK(held.Codes().empty());
  REQUIRE(held.result->grasps.size() == 3);
  for (const Result::Grasp& grasp : held.result->grasps) {
    CHECK(grasp.held);
    CHECK(grasp.width == Approx(0.04));
    CHECK(grasp.pos.norm() < 1e-3);
  }
  const Examined lost = Examine(Cube(0.02), {}, Grasped(4));
  CHECK(lost.Codes() == Strings{"error physics/not-grasped"});
  REQUIRE(lost.result->grasps.size() == 3);
  for (const Result::Grasp& grasp : lost.result->grasps) CHECK_FALSE(grasp.held);
}

TEST_CASE("an object wider than its grip is let go, too") {
  // A motor wider than the open jaws would come to lie on the fingers.
  const Examined drill = Examine(Free(0.5, R"(<geom type="box" size="0.09 0.09 0.09" mass="0.7"/>
                   <geom type="box" size="0.02 0.015 0.07" pos="0 0 -0.16" mass="0.15"/>
                   <site name="grasp" pos="0 0 -0.17"/>)"),
                                 {}, Grasped());
  CHECK(drill.Codes().empty());
}

TEST_CASE("jaws do not close on what is wider than they open") {
  CHECK(Examine(Cube(0.04), {}, Grasped()).Codes() == Strings{"error physics/not-grasped"});
  CHECK(Examine(Cube(0.04), {}, Grasped(30, 0.1)).Codes().empty());
}

TEST_CASE("jaws close at a site along the faces that are there, in the frame of the body") {
  const std::string bar = R"(<geom type="box" size="0.15 0.01 0.004" mass="0.3"/>)";
  const std::string site = R"(<site name="grasp_end" pos="0.1 0 0"/>)";
  const Examined held = Examine(Free(0.2, bar + site), {}, Grasped(60));
  REQUIRE(held.result);
  REQUIRE_FALSE(held.result->grasps.empty());
  const Result::Grasp& first = held.result->grasps.front();
  CHECK(first.site == "grasp_end");
  CHECK(first.pos.x() == Approx(0.1).margin(0.01));
  const Eigen::Quaterniond q(first.quat[0], first.quat[1], first.quat[2], first.quat[3]);
  const Eigen::Vector3d closing = q * Eigen::Vector3d::UnitY();
  CHECK(std::abs(closing.x()) < 0.01);
  CHECK(first.width == Approx(std::abs(closing.z()) > 0.5 ? 0.008 : 0.02));
}

TEST_CASE("a handle on a joint is pulled both ways, and not lifted") {
  const auto drawer = [](double pull) {
    model::Checks checks = Grasped(10);
    checks.grasps->pull = pull;
    return Examine(
        R"(<body name="cabinet" pos="0 0 0.3">)"
        R"(<geom type="box" size="0.2 0.2 0.1" mass="20"/>)"
        R"(<body name="drawer" pos="0 -0.23 0">)"
        R"(<joint name="slide" type="slide" axis="0 -1 0" limited="true" range="0 0.015"/>)"
        R"(<geom type="box" size="0.05 0.02 0.005" mass="0.1"/>)"
        R"(<site name="grasp" pos="0 -0.015 0"/></body></body>)",
        {}, checks);
  };
  CHECK(drawer(5).Codes().empty());
  CHECK(drawer(40).Codes() == Strings{"error physics/not-grasped"});
}

}  // namespace mjforge::physics
