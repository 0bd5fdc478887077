// Friction that makes contacts with pyramidal cones soft.
#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

Strings Frictions(double friction, const std::string& sections = {},
                  const std::string& attributes = {}) {
  const std::string cube = R"(<geom name="cube" type="box" size="0.05 0.05 0.05" friction=")" +
                           std::to_string(friction) + "\" " + attributes + "/>";
  Strings messages;
  for (const diag::Finding& finding :
       Examine(Free(0.05, cube + R"(<geom size="0.01"/>)"), sections).findings)
    if (finding.code == diag::Code::kPhysicsFriction) messages.push_back(finding.message);
  return messages;
}

}  // namespace

TEST_CASE("friction above 2 with pyramidal cones is told with what it does") {
  CHECK(Frictions(2).empty());
  CHECK(Frictions(4) ==
        Strings{"part 'cube' has a friction of 4, more than 2: MuJoCo's pyramidal cones make a "
                "contact the softer the more friction it has; hammers rest 0.16 mm deep with 1, "
                "1.7 mm with 3 and 12 mm with 5"});
  CHECK(Frictions(4, R"(<option cone="elliptic" impratio="20"/>)").empty());
}

TEST_CASE("the friction of what only is seen does not matter") {
  CHECK(Frictions(4, {}, R"(contype="0" conaffinity="0")").empty());
}

}  // namespace mjforge::physics
