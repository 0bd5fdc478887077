// The base MJCF: inertias, mocap bodies, poses, materials, friction.

#include "mjforge/family/base.h"

#include <catch2/catch.hpp>

#include "sample_rows.h"

namespace mjforge::family {
namespace {

TEST_CASE("each body gets the inertia that MuJoCo computed") {
  mjcf::MjcfDocument document;
  document.text =
      "<!-- mjforge 1 -->\n"
      "<mujoco model=\"ball\">\n"
      "  <worldbody>\n"
      "    <body name=\"ball\" pos=\"0 0 0\">\n"
      "      <inertial pos=\"9 9 9\" mass=\"9\"/>\n"
      "      <geom name=\"core\" type=\"sphere\" size=\"1\"/>\n"
      "    </body>\n"
      "  </worldbody>\n"
      "</mujoco>\n";
  const std::string base = BaseOf(document, sample_rows::Ball(2, "oak", 0, 0.25), true);
  CHECK(base ==
        "<mujoco model=\"ball\">\n"
        "  <worldbody>\n"
        "    <body name=\"ball\" pos=\"0 0 0\" mocap=\"true\">\n"
        "      <inertial pos=\"0 0 0.25\" quat=\"1 0 0 0\" mass=\"2\" diaginertia=\"1 1 1\"/>\n"
        "      <geom name=\"core\" type=\"sphere\" size=\"1\"/>\n"
        "    </body>\n"
        "  </worldbody>\n"
        "</mujoco>\n");
}

TEST_CASE("a pose replaces that of the element with this number") {
  const NewPose poses[] = {
      {.tag = "geom", .number = 0, .pos = {1, 2, 3}, .quat = Eigen::Vector4d(0, 1, 0, 0)},
      {.tag = "inertial", .number = 0, .pos = {4, 5, 6}, .quat = {}}};
  const std::string base = WithPoses(sample_rows::kBase, poses);
  CHECK(base.find("size=\"1\" pos=\"1 2 3\" quat=\"0 1 0 0\"/>") != base.npos);
  CHECK(base.find("<inertial pos=\"4 5 6\" quat=\"1 0 0 0\"") != base.npos);
}

TEST_CASE("materials that the base does not have are added once") {
  const Material oak{"oak", "    <material name=\"oak\"/>\n", {}};
  const Material ash{"ash", "    <texture name=\"t\"/>\n    <material name=\"ash\"/>\n", {}};
  const Material elm{"elm", "    <texture name=\"t\"/>\n    <material name=\"elm\"/>\n", {}};
  const Material all[] = {oak, ash, elm};
  const std::string base = WithMaterials(sample_rows::kBase, all);
  CHECK(base.find("    <material name=\"oak\"/>\n    <texture name=\"t\"/>\n"
                  "    <material name=\"ash\"/>\n    <material name=\"elm\"/>\n  </asset>\n") !=
        base.npos);
}

TEST_CASE("friction is given to a joint by its name") {
  const std::pair<std::string, double> joints[] = {{"lid", 0.5}};
  CHECK(WithFrictions("<joint name=\"lid\" type=\"hinge\"/>\n<joint name=\"knob\"/>\n", joints) ==
        "<joint name=\"lid\" type=\"hinge\" frictionloss=\"0.5\"/>\n<joint name=\"knob\"/>\n");
}

}  // namespace
}  // namespace mjforge::family
