// Every kind of difference between the compiled model and the object is found.

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "../mjcf/hand_made.h"
#include "mjforge/validate/validate.h"

namespace mjforge::validate {
namespace {

using hand_made::Line;
using hand_made::Numbers;
using spec::Applies;

Loader& SharedLoader() {
  static Loader loader;
  return loader;
}

model::Object Door() {
  model::Object object = hand_made::Mallet();
  object.bodies[0].parts[0].attributes.push_back(Numbers("condim", Applies::kCollision, {4}));
  object.bodies[0].parts[0].attributes.push_back(Numbers("group", Applies::kVisual, {1}));
  model::Body& body = object.bodies.emplace_back();
  body.name = "mallet_door";
  body.parent = 0;
  body.X_PB.p = {0.3, 0, 0};
  body.mark = Line(50);
  body.parts.push_back(
      hand_made::Solid("mallet_leaf", model::GeomType::kBox, {0.1, 0.01, 0.2}, {}, 51));
  model::Joint& joint = body.joints.emplace_back();
  joint.name = "mallet_hinge";
  joint.type = "hinge";
  joint.range = Eigen::Vector2d(-0.5, 1.5);
  joint.attributes = {Numbers("damping", Applies::kBoth, {0.02})};
  joint.mark = Line(52);
  hand_made::Weigh(object);
  return object;
}

/// Returns the findings if the object is changed after its document was written.
std::vector<std::string> After(const std::function<void(model::Object&)>& change,
                               model::Object object = Door()) {
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(object, mjcf::Target::kMujoco, {}, document);
  change(object);
  diag::Findings findings;
  const bool ok = SharedLoader().Validate(document, object, findings);
  CHECK(ok == findings.empty());
  std::vector<std::string> messages;
  for (const diag::Finding& finding : findings) {
    CHECK(finding.code == diag::Code::kMujocoMismatch);
    messages.push_back(std::to_string(finding.mark.line) + ": " + finding.message);
  }
  return messages;
}

using Messages = std::vector<std::string>;
model::Body& Root(model::Object& object) { return object.bodies[0]; }

TEST_CASE("an unchanged object is as meant") {
  CHECK(After([](model::Object&) {}) == Messages{});
  CHECK(After([](model::Object&) {}, hand_made::Wedge()) == Messages{});
}

TEST_CASE("a missing geom, site, joint or body is found by counting") {
  CHECK(After([](auto& o) { Root(o).parts.pop_back(); }) ==
        Messages{"1: MuJoCo compiled 6 geoms, not 4"});
  CHECK(After([](auto& o) { Root(o).sites.clear(); }) ==
        Messages{"1: MuJoCo compiled 1 sites, not 0"});
  CHECK(After([](auto& o) { Root(o).joints.clear(); }) ==
        Messages{"1: MuJoCo compiled 2 joints, not 1"});
  CHECK(After([](auto& o) { o.bodies.pop_back(); }) ==
        Messages{"1: MuJoCo compiled 2 bodies, not 1", "1: MuJoCo compiled 2 joints, not 1",
                 "1: MuJoCo compiled 6 geoms, not 4"});
}

TEST_CASE("another name is found on every kind of element") {
  CHECK(After([](auto& o) { Root(o).name = "x"; }) ==
        Messages{"1: MuJoCo compiled body 'mallet_root' where 'x' was meant"});
  CHECK(After([](auto& o) { Root(o).parts[0].name = "x"; }) ==
        Messages{"11: MuJoCo compiled geom 'mallet_handle' where 'x' was meant",
                 "11: MuJoCo compiled geom 'mallet_handle_vis' where 'x_vis' was meant"});
  CHECK(After([](auto& o) { Root(o).joints[0].name = "x"; }) ==
        Messages{"2: MuJoCo compiled joint 'mallet_joint0' where 'x' was meant"});
  CHECK(After([](auto& o) { Root(o).sites[0].name = "x"; }) ==
        Messages{"20: MuJoCo compiled site 'mallet_foot' where 'x' was meant"});
}

TEST_CASE("another mass, centre or inertia of a body is found") {
  CHECK(After([](auto& o) { o.bodies[1].mass_properties.mass = 1; }) ==
        Messages{"50: MuJoCo compiled mass of body 'mallet_door' as 0.8, not 1"});
  CHECK(After([](auto& o) { o.bodies[1].mass_properties.p_FCm.y() = 1e-8; }) ==
        Messages{"50: MuJoCo compiled centre of mass 2 of body 'mallet_door' as 0, not 1e-08"});
  const Messages inertia =
      After([](auto& o) { o.bodies[1].mass_properties.I_Cm_F(2, 2) *= 1 + 1e-6; });
  REQUIRE(inertia.size() == 1);
  CHECK(inertia[0].find("50: MuJoCo compiled principal moment 1 of body 'mallet_door' as ") == 0);
  const Messages turned = After([](auto& o) {
    o.bodies[1].mass_properties.I_Cm_F(0, 1) += 1e-6;
    o.bodies[1].mass_properties.I_Cm_F(1, 0) += 1e-6;
  });
  REQUIRE_FALSE(turned.empty());
  CHECK(turned[0].find("50: MuJoCo compiled inertia xy of body 'mallet_door' as ") == 0);
  CHECK(turned[0].ends_with(", not 1e-06"));
  const Messages stated =
      After([](auto& o) { Root(o).mass_properties.I_Cm_F(0, 0) *= 1 + 1e-7; }, hand_made::Wedge());
  REQUIRE(stated.size() == 1);
  CHECK(stated[0].find("1: MuJoCo compiled inertia xx of body 'wedge_root' as ") == 0);
}

TEST_CASE("another type, size or pose of a geom is found on both its geoms") {
  CHECK(After([](auto& o) { Root(o).parts[0].shape.size.x() = 0.011; }) ==
        Messages{"11: MuJoCo compiled size 1 of geom 'mallet_handle' as 0.01, not 0.011",
                 "11: MuJoCo compiled size 1 of geom 'mallet_handle_vis' as 0.01, not 0.011"});
  CHECK(After([](auto& o) { Root(o).parts[0].X_BG.p.z() = -0.001; }) ==
        Messages{"11: MuJoCo compiled pos 3 of geom 'mallet_handle' as 0, not -0.001",
                 "11: MuJoCo compiled pos 3 of geom 'mallet_handle_vis' as 0, not -0.001"});
  CHECK(After([](auto& o) { Root(o).parts[0].shape.type = model::GeomType::kCapsule; }).size() ==
        2);
  CHECK(After([](auto& o) {
          Root(o).parts[0].X_BG.q = Eigen::Quaterniond(0.6, 0.8, 0, 0);
        }).size() == 4);
}

TEST_CASE("a quaternion of the other sign is the same rotation") {
  CHECK(After([](auto& o) { Root(o).parts[1].X_BG.q.coeffs() *= -1; }) == Messages{});
}

TEST_CASE("another attribute of a geom is found where it applies") {
  CHECK(After([](auto& o) { Root(o).parts[0].attributes[0].numbers.Change()[1] = 0.02; }) ==
        Messages{"11: MuJoCo compiled friction 2 of geom 'mallet_handle' as 0.01, not 0.02"});
  CHECK(After([](auto& o) { Root(o).parts[0].attributes[1].numbers.Change()[0] = 0.7; }) ==
        Messages{"11: MuJoCo compiled rgba 1 of geom 'mallet_handle_vis' as 0.6, not 0.7"});
  CHECK(After([](auto& o) { Root(o).parts[0].attributes[2].numbers.Change()[0] = 3; }) ==
        Messages{"11: MuJoCo compiled condim of geom 'mallet_handle' as 4, not 3"});
  CHECK(After([](auto& o) { Root(o).parts[0].attributes[3].numbers.Change()[0] = 2; }) ==
        Messages{"11: MuJoCo compiled group of geom 'mallet_handle_vis' as 1, not 2"});
}

TEST_CASE("a mesh that is elsewhere is found by its corners") {
  const Messages messages =
      After([](auto& o) { Root(o).parts[0].X_BG.p.x() += 1e-4; }, hand_made::Wedge());
  REQUIRE(messages.size() == 4);  // x of two corners of two geoms
  CHECK(messages[0].find("31: MuJoCo compiled lower corner 1 of geom 'wedge_body' as ") == 0);
  CHECK(messages[3].find("31: MuJoCo compiled upper corner 1 of geom 'wedge_body_vis' as ") == 0);
}

TEST_CASE("another joint is found") {
  const auto joint = [](model::Object& o) -> model::Joint& { return o.bodies[1].joints[0]; };
  CHECK(After([&](auto& o) { joint(o).range = Eigen::Vector2d(-0.5, 1); }) ==
        Messages{"52: MuJoCo compiled range 2 of joint 'mallet_hinge' as 1.5, not 1"});
  CHECK(After([&](auto& o) { joint(o).range.reset(); }) ==
        Messages{"52: MuJoCo compiled limited of joint 'mallet_hinge' as 1, not 0"});
  CHECK(After([&](auto& o) { joint(o).type = "slide"; }) ==
        Messages{"52: MuJoCo compiled type of joint 'mallet_hinge' as 3, not 2"});
  CHECK(After([&](auto& o) { joint(o).pos.x() = 0.1; }) ==
        Messages{"52: MuJoCo compiled pos 1 of joint 'mallet_hinge' as 0, not 0.1"});
  CHECK(After([&](auto& o) {
          joint(o).axis = {0, 0, -1};
        }) == Messages{"52: MuJoCo compiled axis 3 of joint 'mallet_hinge' as 1, not -1"});
  CHECK(After([&](auto& o) { joint(o).attributes[0].numbers.Change()[0] = 1; }) ==
        Messages{"52: MuJoCo compiled damping of joint 'mallet_hinge' as 0.02, not 1"});
}

TEST_CASE("an axis of any length means its direction") {
  CHECK(After([](auto& o) { o.bodies[1].joints[0].axis = {0, 0, 5}; }) == Messages{});
}

TEST_CASE("another site or body pose is found") {
  CHECK(After([](auto& o) { Root(o).sites[0].size.x() = 0.006; }) ==
        Messages{"20: MuJoCo compiled size 1 of site 'mallet_foot' as 0.005, not 0.006"});
  CHECK(After([](auto& o) { Root(o).sites[0].X_BS.p.z() = 0; }) ==
        Messages{"20: MuJoCo compiled pos 3 of site 'mallet_foot' as -0.1, not 0"});
  CHECK(After([](auto& o) { o.bodies[1].X_PB.p.x() = 0.4; }) ==
        Messages{"50: MuJoCo compiled pos 1 of body 'mallet_door' as 0.3, not 0.4"});
}

TEST_CASE("a number that is none is a difference") {
  CHECK(After([](auto& o) { Root(o).parts[1].shape.size.x() = std::nan(""); }).size() == 2);
}

}  // namespace
}  // namespace mjforge::validate
