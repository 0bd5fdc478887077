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

/// Returns boxes in a row on a floor.
std::string Boxes(int count) {
  std::string boxes = R"(<geom type="plane" size="9 9 1"/>)";
  for (int i = 0; i < count; ++i) {
    boxes += "<body pos=\"" + std::to_string(0.2 * i) + " 0 0.0499\"><freejoint/>" +
             R"(<geom type="box" size="0.05 0.05 0.05"/></body>)";
  }
  return boxes;
}

TEST_CASE("a model with more contacts than MuJoCo 2.2 has room for is simulated") {
  const Examined boxes = Examine(Boxes(40));
  REQUIRE(boxes.result);
  CHECK(boxes.Codes().empty());
  CHECK(boxes.result->at_rest);
  CHECK(boxes.result->ncon == 160);
}

#if mjVERSION_HEADER < 230
TEST_CASE("a model with more contacts than MuJoCo 2.2 can address is a warning") {
  const Examined boxes = Examine(Boxes(400));
  CHECK_FALSE(boxes.result);
  REQUIRE(boxes.findings.size() == 1);
  CHECK(boxes.Codes() == std::vector<std::string>{"warning mujoco/older"});
  CHECK(boxes.findings[0].message ==
        "'m' is not simulated: MuJoCo 2.2.2 has no room for its contacts");
}
#endif  // later releases have an arena

TEST_CASE("a file for a later release gets a floor, too") {
  const Examined flap = Examine(
      Free(1, kCube + "<body pos=\"0 0 0.1\"><joint name=\"flap\" axis=\"1 0 0\" range=\"0 1\"/>"
                      "<geom size=\"0.02\"/></body>"));
  REQUIRE(flap.result);
  CHECK(flap.result->dropped);
}

TEST_CASE("a stated centre of mass outside the parts is found in any file") {
  const std::string stated =
      R"(<inertial pos="0.3 0 0" mass="1" diaginertia="0.01 0.01 0.01"/>)" + kCube;
  CHECK(Examine("<body name=\"cart\">" + stated + "</body>").Codes() ==
        std::vector<std::string>{"warning physics/center-of-mass"});
}

}  // namespace
}  // namespace mjforge::physics
