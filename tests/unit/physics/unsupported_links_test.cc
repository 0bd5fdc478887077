// Bodies on joints that hang in the air, at the start or at the ends of their ranges.
#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

/// A drawer of 38 cm on a slide, in a cabinet of 40 cm, starting this far in front of the cabinet.
std::string Drawer(const std::string& start, const std::string& joint) {
  return R"(<body name="cabinet" pos="0 0 0.5"><geom type="box" size="0.2 0.2 0.01"/>
    <geom type="box" size="0.2 0.01 0.1" pos="0 0.21 0.1"/>
    <body name="drawer" pos="0 )" +
         start + R"( 0.09"><joint name="pull" damping="5" )" + joint +
         R"(/><geom type="box" size="0.18 0.19 0.07"/></body></body>)";
}

const std::string kSlide = R"(type="slide" axis="0 -1 0" limited="true" )";

Strings Hanging(const Examined& examined) {
  Strings messages;
  for (const diag::Finding& finding : examined.findings)
    if (finding.code == diag::Code::kPhysicsLoose) messages.push_back(finding.message);
  return messages;
}

}  // namespace

TEST_CASE("a drawer that leaves its cabinet hangs in the air") {
  CHECK(Hanging(Examine(Drawer("0", kSlide + R"(range="0 0.3")"))).empty());
  CHECK(Hanging(Examine(Drawer("0", kSlide + R"(range="0 0.48")"))) ==
        Strings{"body 'drawer' hangs in the air where joint 'pull' is at 480 mm: 90.6 mm from all "
                "else of 'm'"});
}

TEST_CASE("a lid that is lifted is in a hand, and does not hang in the air") {
  const std::string lift = R"(type="slide" axis="0 0 1" limited="true" range="0 0.48")";
  CHECK(Hanging(Examine(Drawer("0", lift))).empty());
  CHECK(Hanging(Examine(Drawer("0", lift), R"(<option gravity="0 0 0"/>)")).size() == 1);
}

TEST_CASE("a door that leaves its frame hangs in the air") {
  const std::string hinge = R"(axis="0 0 1" pos="1 0 0" limited="true" )";
  CHECK(Hanging(Examine(Drawer("0", hinge + R"(range="0 0.1")"))).empty());
  const Strings messages = Hanging(Examine(Drawer("0", hinge + R"(range="0 1.5")")));
  REQUIRE(messages.size() == 1);
  INFO(messages[0]);
  CHECK(
      messages[0].starts_with("body 'drawer' hangs in the air where joint 'pull' is at 85.9 deg"));
}

TEST_CASE("a body that starts more than 3 cm away hangs in the air, and a small one less") {
  CHECK(Hanging(Examine(Drawer("-0.415", kSlide + R"(range="0 0.1")"))).size() == 1);
  CHECK(Hanging(Examine(Drawer("-0.445", kSlide + R"(range="0 0.1")"))) ==
        Strings{"body 'drawer' hangs in the air: 55.9 mm from all else of 'm'"});
  const std::string bead =
      R"(<body name="wire"><geom type="capsule" size="0.001 0.1"/><body name="bead" pos="0.01 0 0">
         <joint type="slide" axis="0 0 1" range="0 0.01" limited="true" damping="1"/>
         <geom size="0.003"/></body></body>)";
  CHECK(Hanging(Examine(bead)) ==
        Strings{"body 'bead' hangs in the air: 6 mm from all else of 'm'"});
}

TEST_CASE("joints without ends, and those that others lead, are looked at where they start") {
  CHECK(Hanging(Examine(Drawer("0", R"(axis="0 0 1" pos="1 0 0")"))).empty());
  CHECK(Hanging(Examine(Drawer("0", kSlide + R"(range="0 0.48")"),
                        R"(<equality><joint joint1="pull" polycoef="0 0 0 0 0"/></equality>)"))
            .empty());
}

}  // namespace mjforge::physics
