// Tests of the SimReady benchmark on simple objects.
#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

model::Checks Profile() {
  model::Checks checks;
  checks.simready = true;
  return checks;
}

Result::SimReady Tested(const Examined& object) {
  REQUIRE(object.result);
  REQUIRE(object.result->simready);
  return *object.result->simready;
}

}  // namespace

TEST_CASE("a box passes the SimReady tests, and what rolls on does not come to rest") {
  const Examined box =
      Examine(Free(0.1, R"(<geom type="box" size="0.05 0.04 0.03"/>)"), {}, Profile());
  CHECK(box.Codes().empty());
  CHECK(Tested(box) == Result::SimReady{.ground_drop = "pass", .slope_drop = "pass"});
  // The object lands on a geom that makes it roll.
  const Examined ball = Examine(
      Free(0.1, R"(<geom size="0.02"/><geom type="sphere" size="0.001" pos="0.01 0 -0.018"/>)"), {},
      Profile());
  CHECK(Tested(ball).ground_drop == "fail");
}

TEST_CASE("the way that an object slides is measured along the slope") {
  // In 2 s an object slides by 6.9 m along the slope, and moves by 4.9 m horizontally.
  const auto slope_drop = [](const std::string& half_length) {
    return Tested(Examine(Free(1, "<geom type=\"box\" size=\"" + half_length + " 0.3 0.05\"/>"), {},
                          Profile()))
        .slope_drop;
  };
  CHECK(slope_drop("1.35") == "pass");
  CHECK(slope_drop("1.9") == "fail");
}

TEST_CASE("what is very soft sinks, and what is fixed to the world is not dropped") {
  const Examined soft = Examine(
      Free(0.1, R"(<geom type="box" size="0.05 0.04 0.1" solref="0.5 1" solimp="0.1 0.1 0.1"/>)"),
      {}, Profile());
  CHECK(Tested(soft).ground_drop == "fail");
  const Examined fixed =
      Examine(R"(<body><geom type="box" size="0.05 0.04 0.03"/></body>)", {}, Profile());
  CHECK(Tested(fixed) == Result::SimReady{});
}

TEST_CASE("an object falls as long as it takes, and fails if nothing of it collides") {
  // The fall takes 9.8 s.
  const Examined slow = Examine(Free(1000, R"(<geom type="box" size="3 3 3"/>)"),
                                R"(<option gravity="0 0 -1"/>)", Profile());
  CHECK(Tested(slow).ground_drop == "pass");
  const Examined ghost =
      Examine(Free(0.1, R"(<geom type="box" size="0.1 0.1 0.1" contype="0" conaffinity="0"/>)"), {},
              Profile());
  CHECK(Tested(ghost) == Result::SimReady{.ground_drop = "fail", .slope_drop = "fail"});
}

TEST_CASE("joints must reach both ends of their ranges") {
  const auto door = [](const std::string& stop) {
    return Examine(R"(<body><geom type="box" size="0.02 0.02 0.3"/>)" + stop +
                       R"(<body pos="0.03 0 0"><joint name="hinge" axis="0 0 1" limited="true" )"
                       R"(range="0 1.5"/><geom type="box" size="0.2 0.01 0.25" pos="0.25 0 0"/>)"
                       R"(</body></body>)",
                   {}, Profile());
  };
  CHECK(Tested(door("")).full_range_sweep == "pass");
  CHECK(Tested(door("")).self_collision == "pass");
  CHECK(Tested(door(R"(<geom type="box" size="0.02 0.02 0.3" pos="0.15 0.3 0"/>)"))
            .full_range_sweep == "fail");
}

}  // namespace mjforge::physics
