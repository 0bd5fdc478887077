// Texts and codes of findings about an examined object.
#include "examined.h"

namespace mjforge::physics {
namespace {

TEST_CASE("findings name what moves, by how much, and the threshold") {
  model::Checks checks;
  checks.stable = true;
  const Examined box =
      Examine(Free(1, R"(<geom type="box" size="0.05 0.05 0.05" euler="0.9 0 0"/>)"), {}, checks);
  REQUIRE(box.findings.size() == 1);
  CHECK(box.findings[0].message == "'m' topples: it leans over by 38.4 deg, more than 15 deg");
  CHECK(box.findings[0].mark.line == 1);
}

TEST_CASE("a silenced code makes no finding, others do") {
  const std::string thin_and_loose =
      Free(0, kCube + R"(<geom name="leaf" type="box" size="0.05 0.05 0.0002" pos="0 0 0.06"/>)");
  CHECK(Examine(thin_and_loose).Codes().size() == 3);
  model::Checks checks;
  checks.silenced = {{"physics/thin", "it is a leaf"}, {"physics/slender", "it is a leaf"}};
  CHECK(Examine(thin_and_loose, {}, checks).Codes() ==
        std::vector<std::string>{"warning physics/loose"});
}

TEST_CASE("measured numbers have four digits") {
  const Examined cube = Examine(Free(1, kCube));
  REQUIRE(cube.result);
  char text[32];
  std::snprintf(text, sizeof text, "%.3e", cube.result->penetration);
  CHECK(cube.result->penetration == std::strtod(text, nullptr));
}

TEST_CASE("a file that is none, and one that MuJoCo refuses, are findings") {
  CHECK_FALSE(Examine("<body><geom size=\"-1\"/></body>").result);
  CHECK(Examine("<body><geom size=\"-1\"/></body>").Codes() ==
        std::vector<std::string>{"error mujoco/error"});
  diag::Sources sources;
  diag::Findings findings;
  CHECK_FALSE(Laboratory().Examine("/does/not/exist.xml", {}, sources, findings));
  CHECK(findings.HasErrors());
}

TEST_CASE("a stated centre of mass outside the parts is found in any file") {
  const std::string stated =
      R"(<inertial pos="0.3 0 0" mass="1" diaginertia="0.01 0.01 0.01"/>)" + kCube;
  CHECK(Examine("<body name=\"cart\">" + stated + "</body>").Codes() ==
        std::vector<std::string>{"warning physics/center-of-mass"});
}

}  // namespace
}  // namespace mjforge::physics
