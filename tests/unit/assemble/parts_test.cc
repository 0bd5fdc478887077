// Tests of parts: sizes, poses, roles, mass, attributes.

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

using Eigen::Vector3d;

TEST_CASE("parts have MuJoCo's types and sizes") {
  const Assembling thing(
      "parts:\n"
      "- {name: a, type: sphere, size: [0.1]}\n"
      "- {name: b, type: capsule, size: [0.1, 0.2]}\n"
      "- {name: c, type: ellipsoid, size: [0.1, 0.2, 0.3]}\n"
      "- {name: d, type: cylinder, size: [0.1, 0.2]}\n"
      "- {name: e, type: box, size: [0.1, 0.2, 0.3]}\n");
  CHECK(thing.part("thing_a").shape.type == model::GeomType::kSphere);
  CHECK(thing.part("thing_b").shape.type == model::GeomType::kCapsule);
  CHECK(thing.part("thing_c").shape.size == Vector3d(0.1, 0.2, 0.3));
  CHECK(thing.part("thing_d").shape.size == Vector3d(0.1, 0.2, 0));
  CHECK(thing.part("thing_e").shape.type == model::GeomType::kBox);
  CHECK_FALSE(thing.body().explicit_inertial);
}

TEST_CASE("fromto sets the pose, and the half length beside the sizes across") {
  const Assembling thing(
      "parts:\n"
      "- {name: a, type: capsule, size: [0.1], fromto: [0, 0, 1, 0, 0, 5]}\n"
      "- {name: b, type: box, size: [0.1, 0.2], fromto: [0, 0, 0, 2, 0, 0]}\n");
  const model::Part& a = thing.part("thing_a");
  CHECK(a.shape.size == Vector3d(0.1, 2, 0));
  CHECK(a.X_BG.p == Vector3d(0, 0, 3));
  // In MuJoCo z points from the second end to the first.
  CHECK((a.X_BG.q * Vector3d::UnitZ() - Vector3d(0, 0, -1)).norm() < 1e-14);
  CHECK(thing.part("thing_b").shape.size == Vector3d(0.1, 0.2, 1));
}

TEST_CASE("every way to write a half turn about z gives the same pose") {
  const Assembling thing(
      "parts:\n"
      "- {name: a, type: sphere, size: [1], quat: [0, 0, 0, -5]}\n"
      "- {name: b, type: sphere, size: [1], euler: [0, 0, 180deg]}\n"
      "- {name: c, type: sphere, size: [1], axisangle: [0, 0, 2, 180deg]}\n"
      "- {name: d, type: sphere, size: [1], xyaxes: [-1, 0, 0, 0, -1, 0]}\n"
      "- {name: e, type: sphere, size: [1], zaxis: [0, 0, -1]}\n");
  for (const model::Part& part : thing.body().parts) {
    INFO(part.name);
    CHECK(part.X_BG.q.norm() == Approx(1).epsilon(1e-15));
    const double x = part.name == "thing_e" ? 1 : -1;  // about x instead
    CHECK((part.X_BG.q * Vector3d::UnitX() - Vector3d(x, 0, 0)).norm() < 1e-14);
  }
}

TEST_CASE("rotations that are none are refused") {
  const auto finding = [](const std::string& field) {
    return OnlyFinding("parts: [{name: a, type: sphere, size: [1], " + field + "}]\n");
  };
  CHECK(finding("quat: [0, 0, 0, 0]") == "3:50 quat of part 'a' is zero");
  CHECK(finding("zaxis: [0, 0, 0]") == "3:51 zaxis of part 'a' is zero");
  CHECK(finding("axisangle: [0, 0, 0, 1]") ==
        "3:55 axisangle of part 'a' has an axis of zero length");
  CHECK(finding("xyaxes: [0, 0, 0, 0, 1, 0]") ==
        "3:52 xyaxes of part 'a' has an axis of zero length");
  CHECK(finding("xyaxes: [1, 1, 0, 2, 2, 0]") == "3:52 xyaxes of part 'a' has parallel axes");
}

TEST_CASE("a size that comes out too small is named by its number") {
  CHECK(OnlyFinding("params: {t: 0.02}\n"
                    "parts: [{name: head, type: box, size: [1, 0.01 - t, 1]}]\n") ==
        "4:43 size 2 of part 'head' is -0.01; it must be greater than 0 (it is the value of "
        "'0.01 - t')");
}

TEST_CASE("a chosen size must fit the type") {
  CHECK(OnlyFinding("params: {kind: {choice: [box]}}\n"
                    "parts: [{name: a, type: '${kind}', size: [1, 2]}]\n") ==
        "4:42 size of part 'a' has 2 numbers; a box takes 3");
}

TEST_CASE("a chosen type must exist") {
  CHECK(OnlyFinding("params: {kind: {choice: [spere]}}\n"
                    "parts: [{name: a, type: '${kind}', size: [1]}]\n") ==
        "4:25 type of part 'a' is 'spere'; it must be one of box, sphere, cylinder, capsule, "
        "ellipsoid, prism, lathe, tube, hull, mesh (did you mean 'sphere'?)");
}

TEST_CASE("equal end points are refused") {
  CHECK(OnlyFinding("parts: [{name: a, type: capsule, size: [1], fromto: [1, 2, 3, 1, 2, 3]}]\n") ==
        "3:53 fromto of part 'a' has two equal end points");
}

TEST_CASE("numbers are checked against the bounds of the field table") {
  const auto finding = [](const std::string& field) {
    return OnlyFinding("params: {x: 5, y: 1.5}\nparts: [{name: a, type: sphere, size: [1], " +
                       field + "}]\n");
  };
  CHECK(finding("rgba: [0, x, 0, 1]") ==
        "4:54 rgba 2 of part 'a' is 5; it must be at most 1 (it is the value of 'x')");
  CHECK(finding("friction: -x") ==
        "4:54 friction of part 'a' is -5; it must be at least 0 (it is the value of '-x')");
  CHECK(finding("condim: y") ==
        "4:52 condim of part 'a' is 1.5; it must be a whole number (it is the value of 'y')");
  CHECK(finding("condim: x") ==
        "4:52 condim of part 'a' is 5; it must be 1, 3, 4 or 6 (it is the value of 'x')");
}

TEST_CASE("mass comes from the part, its material, the defaults, or water, in this order") {
  const Assembling thing(
      "materials: {lead: {density: 11340}}\n"
      "defaults: {part: {mass: 7}}\n"
      "parts:\n"
      "- {name: a, type: box, size: [0.5, 0.5, 0.5], density: 3, material: lead}\n"
      "- {name: b, type: box, size: [0.5, 0.5, 0.5], mass: 5, material: lead}\n"
      "- {name: c, type: box, size: [0.5, 0.5, 0.5], material: lead}\n"
      "- {name: d, type: box, size: [0.5, 0.5, 0.5]}\n");
  CHECK(thing.part("thing_a").mass == Approx(3));
  CHECK(thing.part("thing_a").density == 3);
  CHECK(thing.part("thing_b").mass == 5);
  CHECK(thing.part("thing_b").density == 0);
  CHECK(thing.part("thing_c").mass == Approx(11340));
  CHECK(thing.part("thing_d").mass == 7);
  const Assembling water("parts: [{name: a, type: box, size: [0.5, 0.5, 0.5]}]\n");
  CHECK(water.part("thing_a").density == 1000);
}

TEST_CASE("a visual part has mass only by its own word") {
  const Assembling thing(
      "materials: {lead: {density: 11340}}\n"
      "parts:\n"
      "- {name: a, type: sphere, size: [1], role: visual, material: lead}\n"
      "- {name: b, type: sphere, size: [1], role: visual, mass: 2}\n"
      "- {name: c, type: sphere, size: [1], role: visual, density: 0}\n");
  CHECK(thing.part("thing_a").mass == 0);
  CHECK(thing.part("thing_b").mass == 2);
  CHECK(thing.part("thing_c").mass == 0);
  CHECK(thing.object().mass_properties.mass == 2);
}

TEST_CASE("a colliding part must have mass") {
  CHECK(OnlyFinding("params: {d: 0}\n"
                    "parts: [{name: a, type: sphere, size: [1], density: d}]\n") ==
        "4:53 density of part 'a' is 0; it must be greater than 0 (a part without mass has `role: "
        "visual` or `role: collision`)");
}

TEST_CASE("a part that only collides may be without mass, if its body has some") {
  const std::string colliders =
      "- {name: a, type: sphere, size: [1], role: collision, mass: 0}\n"
      "- {name: b, type: sphere, size: [1], role: collision, density: 0}\n"
      "- {name: c, type: lathe, profile: [[0, 0], [1, 0], [2, 1]], wall: 0.1, role: collision, "
      "mass: 0}\n";
  const Assembling thing(
      "parts:\n- {name: w, type: box, size: [1, 1, 1], role: visual, mass: 2}\n" + colliders);
  CHECK(thing.object().mass_properties.mass == 2);
  CHECK(thing.object().mass_properties.p_FCm == Vector3d::Zero());
  CHECK(thing.part("thing_a").role == model::Role::kCollision);
  CHECK(thing.part("thing_c_0").mass == 0);
  CHECK(OnlyFinding("parts:\n" + colliders).find("can move but has no mass") != std::string::npos);
  CHECK_FALSE(Assembling("joints: none\nparts:\n" + colliders).failed());
}

TEST_CASE("attributes come from the part, its material and the defaults, in this order") {
  const Assembling thing(
      "materials: {wood: {friction: 2, solref: [0.1, 1]}}\n"
      "defaults: {part: {friction: 3, solref: [0.2, 1], margin: 0.001}}\n"
      "parts: [{name: a, type: sphere, size: [1], friction: [1, 0.1], material: wood}]\n");
  const std::vector<model::Attribute>& attributes = thing.part("thing_a").attributes;
  REQUIRE(attributes.size() == 3);
  CHECK(model::FindAttribute(attributes, "friction")->numbers == sample::Numbers{1, 0.1});
  CHECK(model::FindAttribute(attributes, "friction")->applies == spec::Applies::kCollision);
  CHECK(model::FindAttribute(attributes, "solref")->numbers == sample::Numbers{0.1, 1});
  CHECK(model::FindAttribute(attributes, "margin")->numbers == sample::Numbers{0.001});
}

TEST_CASE("a draw in a part is keyed by the part's name, not by its place") {
  const std::string a = "- {name: a, type: sphere, size: [0.1 .. 0.2]}\n";
  const std::string b = "- {name: b, type: sphere, size: [0.1 .. 0.2]}\n";
  const Assembling first("parts:\n" + a + b);
  const Assembling second("parts:\n" + b + a);
  CHECK(first.part("thing_a").shape.size == second.part("thing_a").shape.size);
  CHECK(first.part("thing_b").shape.size == second.part("thing_b").shape.size);
  CHECK(first.part("thing_a").shape.size != first.part("thing_b").shape.size);
}

TEST_CASE("a drawn size has the stream of spec, parts, name and key") {
  const Assembling thing("parts: [{name: a, type: sphere, size: [0.1 .. 0.2]}]\n", 7, 3);
  sample::StreamId path = sample::kRootStream;
  for (const char* step : {"thing", "parts", "a", "size", "0"}) path = sample::Child(path, step);
  const double u = sample::Uniforms({.seed = 7, .index = 3}, path)[0];
  CHECK(thing.part("thing_a").shape.size.x() ==
        sample::RoundWithin(0.1, 0.2, 0.1 + u * (0.2 - 0.1)));
}

}  // namespace
}  // namespace mjforge::assemble
