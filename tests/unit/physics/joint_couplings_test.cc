// Tests of couplings of joints by equalities.
#include "mjforge/physics/joint_couplings.h"

#include <catch2/catch.hpp>

#include "examined.h"

namespace mjforge::physics {

TEST_CASE("a joint follows another one, whatever the order of the equalities") {
  const std::string bodies =
      R"(<body name="one"><joint name="a"/><geom size="0.1"/></body>
      <body name="two" pos="1 0 0"><joint name="b"/><geom size="0.1"/></body>)";
  const std::string pin = R"(<connect body1="one" anchor="0 0 0"/>)";
  const std::string gear = R"(<joint joint1="b" joint2="a" polycoef="0 3 0 0 0"/>)";
  for (const std::string& equalities : {pin + gear, gear + pin}) {
    const engine::Model m =
        Load("<worldbody>" + bodies + "</worldbody><equality>" + equalities + "</equality>");
    const JointCouplings couplings(*m);
    CHECK(couplings.IsCoupled(0));
    const auto setpoint =
        couplings.SetpointOf(1, 0, {.position = 0.5, .speed = 0, .acceleration = 0});
    REQUIRE(setpoint);
    CHECK(setpoint->position == 1.5);
  }
}

}  // namespace mjforge::physics
