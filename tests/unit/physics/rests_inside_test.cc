// Bodies that do not collide and come to rest in each other.
#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

/// A plate of 6 mm that lies on a block, 10 cm high, or falls through it to the floor.
std::string Plate(const std::string& attributes) {
  return Free(0.05, kCube) +
         R"(<body name="plate" pos="0 0 0.103"><freejoint/><geom type="cylinder" size="0.04 0.003" )" +
         attributes + "/></body>";
}

const std::string kExclude = R"(<contact><exclude body1="root" body2="plate"/></contact>)";

Strings RestsInside(const Examined& examined) {
  Strings messages;
  for (const diag::Finding& finding : examined.findings)
    if (finding.code == diag::Code::kPhysicsRestsInside) messages.push_back(finding.message);
  return messages;
}

}  // namespace

TEST_CASE("an excluded body that falls into another one is told") {
  CHECK(RestsInside(Examine(Plate(""))).empty());
  const Strings messages = RestsInside(Examine(Plate(""), kExclude));
  REQUIRE(messages.size() == 1);
  INFO(messages[0]);
  CHECK(messages[0].starts_with("bodies 'root' and 'plate' come to rest "));
  CHECK(
      messages[0].ends_with(" mm in each other, and start 0 mm in each other: their contact is "
                            "excluded"));
}

TEST_CASE("so is a body whose contact bits do not match, but not one that is paired") {
  // The floor has contype 1 and conaffinity 1, and stops both.
  const std::string bits = R"(contype="2" conaffinity="1")";
  const std::string cube = Free(
      0.05, R"(<geom name="cube" type="box" size="0.05 0.05 0.05" contype="4" conaffinity="1"/>)");
  const std::string plate = Plate(R"(name="disc" )" + bits).substr(Free(0.05, kCube).size());
  const Strings messages = RestsInside(Examine(cube + plate));
  REQUIRE(messages.size() == 1);
  CHECK(messages[0].ends_with("their contact bits do not match"));
  CHECK(
      RestsInside(Examine(cube + plate, R"(<contact><pair geom1="cube" geom2="disc"/></contact>)"))
          .empty());
}

TEST_CASE("bodies may be in each other from the start, and parents in their children") {
  // An axle in a wheel, which is no child of the axle's body.
  const std::string hub = Free(0.04, R"(<geom type="cylinder" size="0.01 0.05" euler="1.5708 0 0"/>
    <body name="arm"><geom type="box" size="0.005 0.005 0.05" pos="0 0 0.05"/><body name="wheel">
      <joint axis="0 1 0" damping="0.01"/>
      <geom type="cylinder" size="0.04 0.01" euler="1.5708 0 0"/></body></body>)");
  CHECK(RestsInside(Examine(hub, R"(<contact><exclude body1="root" body2="wheel"/></contact>)"))
            .empty());
}

TEST_CASE("a body may turn into a parent that is fixed to the world") {
  const std::string post =
      "<body name=\"post\">" + kCube +
      R"(<body name="bar" pos="0 0 0.05"><joint axis="0 1 0" damping="0.05" range="0 1" limited="true"/>
        <geom type="box" size="0.06 0.005 0.02" pos="0.02 0 0.021"/></body></body>)";
  CHECK(RestsInside(Examine(post, R"(<contact><exclude body1="post" body2="bar"/></contact>)"))
            .empty());
}

}  // namespace mjforge::physics
