// Containment tests: which objects keep, lose and release balls.
#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

constexpr const char* kHard = R"( solref="0.005 1" solmix="100"/>)";

// A box of five boards, 80 mm wide inside and 60 mm high, with a floor of this thickness, m.
std::string Box(double floor, const std::string& more = {}) {
  const std::string board = R"(<geom type="box" size=")";
  return board + "0.05 0.05 " + std::to_string(floor / 2) + "\"" + kHard + board +
         R"(0.005 0.05 0.03" pos="0.045 0 0.03")" + kHard + board +
         R"(0.005 0.05 0.03" pos="-0.045 0 0.03")" + kHard + board +
         R"(0.05 0.005 0.03" pos="0 0.045 0.03")" + kHard + board +
         R"(0.05 0.005 0.03" pos="0 -0.045 0.03")" + kHard + more;
}

// A lid that is open at 1.5 rad.
constexpr const char* kLid =
    R"(<body name="m_lid" pos="0 0.05 0.065"><joint name="hinge" axis="-1 0 0" range="0 2" limited="true"/>)"
    R"(<geom type="box" size="0.05 0.05 0.002" pos="0 -0.05 0"/></body>)";

model::Checks Holds(double smallest, double largest, bool empties = true) {
  model::Checks checks;
  model::HoldingCheck& holds = checks.holds.emplace();
  holds.ball = {smallest, largest};
  holds.empties = empties;
  checks.silenced = {{"physics/overlap", "the boards meet in the corners"},
                     {"physics/joint-collides", "the lid lies on the walls"}};
  return checks;
}

using Holding = Result::Holding;

TEST_CASE("balls stay in a box and come out as it is turned over") {
  const auto check = [](const std::string& world) {
    INFO(world);
    const Examined box = Examine(world, {}, Holds(0.008, 0.02));
    REQUIRE(box.result);
    CHECK(box.Codes().empty());
    CHECK(box.result->holds == Holding{5, 5, 5});
  };
  check("<body name=\"fixed\">" + Box(0.004) + "</body>");
  check(Free(0.3, Box(0.004)));  // the object does not fall
}

TEST_CASE("what is not asked for is not measured, and what need not come out is not turned") {
  const std::string world = Free(0, Box(0.004));
  CHECK_FALSE(Examine(world).result->holds);
  CHECK(Examine(world, {}, Holds(0.008, 0.008, false)).result->holds == Holding{5, 5, 0});
}

TEST_CASE("a ball that is faster than the floor is thick falls through it") {
  model::Checks checks = Holds(0.003, 0.003);
  checks.holds->drop = 1;  // 4.5 m/s: 9 mm in a step
  const Examined box = Examine(Free(0, Box(0.0015)), {}, checks);
  CHECK(box.Codes() == Strings{"error physics/leaks"});
  CHECK(box.result->holds->held < 5);
  CHECK(box.findings.begin()->message.find("below its top") != std::string::npos);
}

TEST_CASE("what is the same from all sides is held, too") {
  // Four walls around the centre of mass, without a floor.
  const std::string pipe = R"(<geom type="box" size="0.05 0.004 0.03" pos="0 0.05 0"/>)"
                           R"(<geom type="box" size="0.05 0.004 0.03" pos="0 -0.05 0"/>)"
                           R"(<geom type="box" size="0.004 0.05 0.03" pos="0.05 0 0"/>)"
                           R"(<geom type="box" size="0.004 0.05 0.03" pos="-0.05 0 0"/>)";
  const Examined box = Examine(Free(0, pipe), {}, Holds(0.008, 0.02));
  CHECK(box.Codes() == Strings{"error physics/leaks"});
  CHECK(box.result->holds == Holding{5, 0, 0});
}

TEST_CASE("balls that fall beside it are not held") {
  model::Checks checks = Holds(0.01, 0.01);
  checks.holds->at = Eigen::Vector2d(0.2, 0);
  const Examined box = Examine(Free(0, Box(0.004)), {}, checks);
  CHECK(box.Codes() == Strings{"error physics/leaks"});
  CHECK(box.result->holds == Holding{5, 0, 0});
  CHECK(box.findings.begin()->message.find("over its top") != std::string::npos);
}

TEST_CASE("a lid is in the way where it starts, open or closed, and can be taken away") {
  const std::string world = Free(0, Box(0.004, kLid));
  const std::string open = R"(<keyframe><key name="m_start" qpos="0 0 0 1 0 0 0 1.5"/></keyframe>)";
  model::Checks checks = Holds(0.008, 0.02);
  checks.holds->at = Eigen::Vector2d(0, 0);
  CHECK(Examine(world, {}, checks).result->holds->held == 0);
  CHECK(Examine(world, open, checks).result->holds->held == 5);
  for (const char* name : {"lid", "m_lid"}) {
    checks.holds->without = name;
    CHECK(Examine(world, {}, checks).result->holds == Holding{5, 5, 5});
  }
  checks.holds->without = "lit";
  const Examined box = Examine(world, {}, checks);
  CHECK(box.Codes() == Strings{"error model/unknown-reference"});
  CHECK(box.findings.begin()->hint == "did you mean 'lid'?");
}

TEST_CASE("what is below a ledge stays inside") {
  const std::string ledge = R"(<geom type="box" size="0.05 0.02 0.002" pos="0 0.03 0.062"/>)"
                            R"(<geom type="box" size="0.05 0.02 0.002" pos="0 -0.03 0.062"/>)";
  const Examined box = Examine(Free(0, Box(0.004, ledge)), {}, Holds(0.012, 0.012));
  CHECK(box.Codes() == Strings{"error physics/keeps"});
  CHECK(box.result->holds->held == 5);
  CHECK(box.result->holds->emptied < 5);
}

TEST_CASE("what does not collide holds nothing") {
  const Examined ghost = Examine(
      R"(<body name="ghost"><geom type="box" size="1 1 1" contype="0" conaffinity="0"/></body>)",
      {}, Holds(0.01, 0.01));
  REQUIRE(ghost.result);
  CHECK(ghost.result->holds == Holding{5, 0, 0});
}

}  // namespace
}  // namespace mjforge::physics
