// Bodies in their parents, where they start and as their joints move.
#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

/// A wheel of this width between two arms that are 28 mm apart, which are its parent.
std::string Fork(const std::string& half_width) {
  return Free(0.04, R"(<geom type="box" size="0.03 0.03 0.004" pos="0 0 0.06"/>
    <geom type="box" size="0.01 0.002 0.03" pos="0 0.016 0.03"/>
    <geom type="box" size="0.01 0.002 0.03" pos="0 -0.016 0.03"/>
    <body name="wheel"><joint name="roll" axis="0 1 0" damping="0.001"/>
      <geom type="cylinder" euler="1.5708 0 0" size="0.04 )" +
                        half_width + "\"/></body>");
}

/// A lamp whose shade stands on a ball joint on a post, its parent.
std::string Lamp(const std::string& range) {
  return Free(0, R"(<geom type="cylinder" size="0.12 0.01" pos="0 0 0.01" density="8000"/>
    <geom type="cylinder" size="0.006 0.15" pos="0 0 0.17"/>
    <body name="head" pos="0 0 0.33"><joint name="socket" type="ball" damping="0.2" )" +
                     range + R"(/><geom type="capsule" size="0.02" fromto="0 0 0.028 0 0 0.06"/>
    </body>)");
}

Strings Passes(const Examined& examined) {
  Strings messages;
  for (const diag::Finding& finding : examined.findings)
    if (finding.code == diag::Code::kPhysicsJointPasses) messages.push_back(finding.message);
  return messages;
}

}  // namespace

TEST_CASE("a body that starts in its parent is told, once") {
  CHECK(Passes(Examine(Fork("0.013"))).empty());
  CHECK(Passes(Examine(Fork("0.017"))) ==
        Strings{"body 'wheel' is 3 mm in its parent 'root' where joint 'roll' starts; MuJoCo does "
                "not let the two collide"});
  model::Checks checks;
  checks.joints = {{.joints = {"roll"}, .penetration = 0.004}};
  CHECK(Passes(Examine(Fork("0.017"), {}, checks)).empty());
}

TEST_CASE("a ball joint is turned about each axis") {
  const Strings unlimited = Passes(Examine(Lamp("")));
  REQUIRE(unlimited.size() == 1);
  INFO(unlimited[0]);
  CHECK(unlimited[0].starts_with("joint 'socket' moves body 'head' "));
  CHECK(Passes(Examine(Lamp(R"(limited="true" range="0 1.2")"))).empty());
}

}  // namespace mjforge::physics
