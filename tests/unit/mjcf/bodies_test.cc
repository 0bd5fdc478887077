#include <catch2/catch.hpp>
#include <pugixml.hpp>

#include "hand_made.h"
#include "mjforge/mjcf/mjcf.h"

namespace mjforge::mjcf {
namespace {

using hand_made::Numbers;
using model::GeomType;
using model::Role;
using spec::Applies;

/// Returns the line of the element with this name, without indentation and newline.
std::string LineOf(const model::Object& object, const std::string& tag, const std::string& name) {
  MjcfDocument document;
  WriteMjcf(object, Target::kMujoco, {}, document);
  const std::size_t begin = document.text.find("<" + tag + " name=\"" + name + "\"");
  if (begin == std::string::npos) return {};
  return document.text.substr(begin, document.text.find('\n', begin) - begin);
}

model::Object Ball(Role role) {
  model::Object object = hand_made::Empty("ball");
  object.bodies[0].parts.push_back(
      hand_made::Solid("ball_g", GeomType::kSphere, {0.1, 0, 0}, {}, 5));
  object.bodies[0].parts[0].role = role;
  object.bodies[0].parts[0].attributes = {
      Numbers("solref", Applies::kCollision, {0.02, 1}), Numbers("user", Applies::kBoth, {3}),
      Numbers("rgba", Applies::kVisual, {0, 1, 0, 1}), Numbers("group", Applies::kVisual, {1})};
  model::Material material;
  material.name = "ball_red";
  object.materials.push_back(material);
  object.bodies[0].parts[0].material = 0;
  return object;
}

TEST_CASE("a part in both roles has its physics on one geom and its look on the other") {
  const model::Object object = Ball(Role::kBoth);
  CHECK(LineOf(object, "geom", "ball_g") ==
        R"(<geom name="ball_g" type="sphere" size="0.1" pos="0 0 0" density="500" )"
        R"(solref="0.02 1" user="3" group="3" rgba="0.5 0 0 1"/>)");
  CHECK(LineOf(object, "geom", "ball_g_vis") ==
        R"(<geom name="ball_g_vis" type="sphere" size="0.1" pos="0 0 0" contype="0" )"
        R"(conaffinity="0" mass="0" material="ball_red" user="3" rgba="0 1 0 1" group="1"/>)");
}

TEST_CASE("a collision part has its look on its only geom") {
  const model::Object object = Ball(Role::kCollision);
  CHECK(LineOf(object, "geom", "ball_g") ==
        R"(<geom name="ball_g" type="sphere" size="0.1" pos="0 0 0" density="500" )"
        R"(material="ball_red" solref="0.02 1" user="3" rgba="0 1 0 1" group="1"/>)");
  CHECK(LineOf(object, "geom", "ball_g_vis").empty());
}

TEST_CASE("a collision part without a look is red") {
  model::Object object = Ball(Role::kCollision);
  object.bodies[0].parts[0].material = -1;
  object.bodies[0].parts[0].attributes.clear();
  CHECK(LineOf(object, "geom", "ball_g") ==
        R"(<geom name="ball_g" type="sphere" size="0.1" pos="0 0 0" density="500" group="3" )"
        R"(rgba="0.5 0 0 1"/>)");
}

TEST_CASE("a visual part has one geom without contacts, massless unless it has a mass") {
  model::Object object = Ball(Role::kVisual);
  object.bodies[0].parts[0].mass = 0;
  CHECK(LineOf(object, "geom", "ball_g").empty());
  CHECK(LineOf(object, "geom", "ball_g_vis") ==
        R"(<geom name="ball_g_vis" type="sphere" size="0.1" pos="0 0 0" contype="0" )"
        R"(conaffinity="0" mass="0" material="ball_red" user="3" rgba="0 1 0 1" group="1"/>)");
  object.bodies[0].parts[0].mass = 0.25;
  object.bodies[0].parts[0].density = 0;
  CHECK(LineOf(object, "geom", "ball_g_vis").find(" mass=\"0.25\" ") != std::string::npos);
}

TEST_CASE("joints state type, axis and limits; a free one nothing else") {
  model::Object object = Ball(Role::kBoth);
  model::Joint hinge;
  hinge.name = "lid";
  hinge.type = "hinge";
  hinge.axis = {0, 1, 0};
  hinge.range = Eigen::Vector2d(0, 1.5);
  hinge.attributes = {Numbers("damping", Applies::kBoth, {0.01})};
  model::Joint slide = hinge;
  slide.name = "drawer";
  slide.type = "slide";
  slide.range.reset();
  slide.attributes.clear();
  object.bodies[0].joints.push_back(hinge);
  object.bodies[0].joints.push_back(slide);
  CHECK(LineOf(object, "joint", "ball_joint0") == R"(<joint name="ball_joint0" type="free"/>)");
  CHECK(LineOf(object, "joint", "lid") ==
        R"(<joint name="lid" type="hinge" pos="0 0 0" axis="0 1 0" limited="true" range="0 1.5" )"
        R"(damping="0.01"/>)");
  CHECK(LineOf(object, "joint", "drawer") ==
        R"(<joint name="drawer" type="slide" pos="0 0 0" axis="0 1 0" limited="false"/>)");
}

TEST_CASE("bodies nest depth first, children in their order") {
  model::Object object = hand_made::Empty("tree");
  const std::pair<const char*, int> bodies[] = {
      {"a", 0}, {"b", 0}, {"a1", 1}, {"b1", 2}, {"a2", 1}};
  for (const auto& [name, parent] : bodies) {
    object.bodies.emplace_back().name = name;
    object.bodies.back().parent = parent;
  }
  CHECK(DepthFirstOrder(object) == std::vector<int>{0, 1, 3, 5, 2, 4});
  MjcfDocument document;
  WriteMjcf(object, Target::kMujoco, {}, document);
  pugi::xml_document parsed;
  REQUIRE(parsed.load_buffer(document.text.data(), document.text.size()));
  CHECK(parsed.select_node("//body[@name='a']/body[@name='a1']"));
  CHECK(parsed.select_node("//body[@name='a']/body[@name='a2']"));
  CHECK(parsed.select_node("//body[@name='b']/body[@name='b1']"));
  CHECK(parsed.select_node("/mujoco/worldbody/body[@name='tree_root']/body[@name='b']"));
}

TEST_CASE("a flat body states an inertia that MuJoCo accepts") {
  model::Object object = Ball(Role::kBoth);
  model::Body& body = object.bodies[0];
  body.explicit_inertial = true;
  body.mass_properties.mass = 1;
  body.mass_properties.p_FCm = {0, 0, 0};
  body.mass_properties.I_Cm_F = Eigen::Vector3d(1.0 / 12, 1.0 / 12, 1.0 / 6).asDiagonal();
  MjcfDocument document;
  WriteMjcf(object, Target::kMujoco, {}, document);
  pugi::xml_document parsed;
  REQUIRE(parsed.load_buffer(document.text.data(), document.text.size()));
  // Rounded to ten digits, 1/12 + 1/12 is less than 1/6.
  CHECK(std::string(parsed.select_node("//inertial/@diaginertia").attribute().value()) ==
        "0.08333333333 0.08333333333 0.1666666663");
}

TEST_CASE("given axes of inertia are written unless they are no principal axes any more") {
  model::Object object = Ball(Role::kBoth);
  model::Body& body = object.bodies[0];
  body.explicit_inertial = true;
  body.mass_properties.mass = 1;
  body.principal_axes = Eigen::Quaterniond(0.8, 0, 0, 0.6);
  const Eigen::Matrix3d axes = body.principal_axes->toRotationMatrix();
  const auto inertial = [&](const Eigen::Matrix3d& inertia) {
    body.mass_properties.I_Cm_F = inertia;
    MjcfDocument document;
    WriteMjcf(object, Target::kMujoco, {}, document);
    const std::size_t begin = document.text.find("<inertial");
    return document.text.substr(begin, document.text.find('\n', begin) - begin);
  };
  const Eigen::Matrix3d tensor =
      axes * Eigen::Vector3d(0.3, 0.1, 0.2).asDiagonal() * axes.transpose();
  CHECK(inertial(tensor) ==
        R"(<inertial pos="0 0 0" quat="0.8 0 0 0.6" mass="1" diaginertia="0.3 0.1 0.2"/>)");
  CHECK(inertial(Eigen::Vector3d(0.1, 0.2, 0.3).asDiagonal()) ==
        R"(<inertial pos="0 0 0" mass="1" diaginertia="0.1 0.2 0.3"/>)");
}

TEST_CASE("a body with a prism states its inertia") {
  const model::Object object = hand_made::Wedge();
  MjcfDocument document;
  WriteMjcf(object, Target::kMujoco, {}, document);
  pugi::xml_document parsed;
  REQUIRE(parsed.load_buffer(document.text.data(), document.text.size()));
  const pugi::xml_node body = parsed.child("mujoco").child("worldbody").child("body");
  const pugi::xml_node inertial = body.first_child();
  CHECK(std::string(inertial.name()) == "inertial");
  CHECK(inertial.attribute("mass").as_double() ==
        Approx(object.mass_properties.mass).epsilon(1e-9));
  CHECK(inertial.attribute("diaginertia"));
  CHECK(document.Origin(8).line == 1);
}

TEST_CASE("a massless body states the least mass where MuJoCo 2.2 asks for one, and none else") {
  model::Object object = Ball(Role::kVisual);
  object.bodies[0].parts[0].mass = 0;
  object.bodies[0].joints.clear();
  MjcfDocument document;
  WriteMjcf(object, Target::kMujoco, {}, document);
  CHECK(document.text.find("<inertial") == std::string::npos);
  object.bodies[0].parts.push_back(object.bodies[0].parts[0]);
  WriteMjcf(object, Target::kMujoco, {}, document);
  CHECK(document.text.find(
            "      <inertial pos=\"0 0 0\" mass=\"1e-15\" diaginertia=\"0 0 0\"/>\n") !=
        std::string::npos);
}

}  // namespace
}  // namespace mjforge::mjcf
