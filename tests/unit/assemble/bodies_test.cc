// Tests of `bodies:`: parents, poses, properties, nested specs, free bodies.

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

const model::Body& BodyOf(const Assembling& thing, const std::string& name) {
  for (const model::Body& body : thing.object().bodies) {
    if (body.name == name) return body;
  }
  FAIL("no body " << name);
  return thing.body();
}

// A box 0.2 x 0.4 x 0.6 m on the floor of its frame.
constexpr const char* kBox =
    "parts: [{name: 'g', type: box, size: [0.1, 0.2, 0.3], pos: [0, 0, 0.3], density: 1000}]";

}  // namespace

TEST_CASE("bodies hang on the root or on earlier ones") {
  const Assembling thing(
      "bodies:\n"
      "- {name: a, parts: [{name: g, type: sphere, size: 1}], pos: [1, 0, 0]}\n"
      "- {name: b, parent: a, parts: [{name: h, type: sphere, size: 1}], pos: [0, 2, 0]}\n"
      "- {name: c, parent: thing}\n");
  const auto& bodies = thing.object().bodies;
  REQUIRE(bodies.size() == 4);
  CHECK(bodies[0].name == "thing");
  CHECK(bodies[1].name == "thing_a");
  CHECK(bodies[1].parent == 0);
  CHECK(bodies[2].parent == 1);
  CHECK(bodies[3].parent == 0);
  CHECK(bodies[2].parts.at(0).name == "thing_h");
  CHECK(model::BodyPoses(thing.object())[2].p == Eigen::Vector3d(1, 2, 0));
}

TEST_CASE("a property of a body may stand alone") {
  const Assembling thing(
      "bodies:\n"
      "- {name: a, parts: [{name: g, type: sphere, size: 0.25}]}\n"
      "- {name: b, parts: [{name: h, type: sphere, size: a.top}]}\n"
      "- {name: c, parts: [{name: k, type: box, size: [{choice: [a.radius]}, 1, 1]}]}\n");
  CHECK(thing.object().bodies[2].parts[0].shape.size.x() == 0.25);
  CHECK(thing.object().bodies[3].parts[0].shape.size.x() == 0.25);
}

TEST_CASE("parents are found by composed names, too") {
  const Assembling thing(
      "bodies:\n"
      "- {name: 'link_${i}', for: {i: 3}, parent: '${i == 0}', parts: []}\n");
  CHECK(thing.failed());
  const Assembling chain(
      "bodies:\n"
      "- {name: link_0, parts: [{name: g0, type: sphere, size: 1}]}\n"
      "- {name: 'link_${i + 1}', for: {i: 3}, parent: 'link_${i}', pos: [1, 0, 0],\n"
      "   parts: [{name: 'g${i + 1}', type: sphere, size: 1}]}\n");
  CHECK(chain.object().bodies.size() == 5);
  CHECK(model::BodyPoses(chain.object())[4].p == Eigen::Vector3d(3, 0, 0));
}

TEST_CASE("a parent that no body before it makes is reported at both places") {
  const Assembling thing(
      "bodies:\n"
      "- {name: 'link_${i}', for: {i: 2}}\n"
      "- {name: hand, parent: lnk_1}\n");
  CHECK(thing.findings() ==
        std::vector<std::string>{"5:24 body 'hand': no earlier body 'lnk_1' (did you mean "
                                 "'link_1'?)"});
  CHECK(thing.raw_findings()[0].notes.size() == 1);
}

TEST_CASE("rotated poses compose") {
  const Assembling thing(
      "bodies:\n"
      "- {name: a, pos: [1, 0, 0], euler: [0, 0, 90deg]}\n"
      "- {name: b, parent: a, pos: [1, 0, 0], euler: [90deg, 0, 0],\n"
      "   parts: [{name: g, type: box, size: [1, 2, 3]}]}\n");
  const model::Pose X = model::BodyPoses(thing.object())[2];
  CHECK((X.p - Eigen::Vector3d(1, 1, 0)).norm() < 1e-15);
  // The z axis of the body is along -y of a, which is along x of the root.
  CHECK((X.q * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm() < 1e-15);
  const model::Box3& box = thing.object().bounds.aabb;
  CHECK((box.max - Eigen::Vector3d(1 + 3, 1 + 1, 2)).norm() < 1e-12);
}

TEST_CASE("a body's properties are those of what it holds, at its own origin") {
  const Assembling thing(std::string("bodies:\n- {name: a, pos: [5, 5, 5], ") + kBox +
                         "}\n"
                         "- {name: b, pos: [a.half_x, a.half_y, a.half_z]}\n"
                         "- {name: c, pos: [a.top, a.bottom, a.radius]}\n"
                         "- {name: d, pos: [a.mass * 1m / 1kg, 0, 0]}\n");
  CHECK((BodyOf(thing, "thing_b").X_PB.p - Eigen::Vector3d(0.1, 0.2, 0.3)).norm() < 1e-15);
  CHECK((BodyOf(thing, "thing_c").X_PB.p - Eigen::Vector3d(0.6, 0, std::hypot(0.1, 0.2))).norm() <
        1e-15);
  CHECK(BodyOf(thing, "thing_d").X_PB.p.x() == Approx(48).epsilon(1e-12));
}

TEST_CASE("a property of a body that is left out has no value") {
  const Assembling thing(std::string("bodies:\n- {name: a, if: 1 > 2, ") + kBox +
                         "}\n- {name: b, pos: [a.top, 0, 0], parts: [{name: h, type: sphere, size: "
                         "1}]}\n");
  CHECK(
      thing.findings() ==
      std::vector<std::string>{"5:19 expression 'a.top' uses 'a.top', which has no value in this "
                               "variant (it was left out by 'if' or 'fewer', or is placed later)"});
}

TEST_CASE("a text parameter of a body that is left out has no value") {
  const TemporaryFolder folder;
  folder.Write("arm.yaml",
               "mjforge: 1\nname: arm\nparams: {kind: {choice: [long, short]}}\n"
               "parts: [{name: base, type: sphere, size: 0.1}]\n");
  const auto findings_of = [&](const std::string& body) {
    const std::string spec = "bodies:\n- {name: a, if: 1 > 2, spec: arm.yaml}\n- " + body + "\n";
    return Assembling(spec, 1, 0, folder.path()).findings();
  };
  CHECK(findings_of("{name: b, parts: [{name: \"h_${a.kind}\", type: sphere, size: 1}]}") ==
        std::vector<std::string>{"5:28 'a.kind' has no value in this variant (it was left out by "
                                 "'if' or 'fewer', or is placed later)"});
  CHECK(findings_of("{name: b, if: a.kind == 'long', parts: [{name: h, type: sphere, size: 1}]}") ==
        std::vector<std::string>{
            "5:3 expression 'a.kind == 'long'' uses 'a.kind', which has no "
            "value in this variant (it was left out by 'if' or 'fewer', or is placed later)"});
}

TEST_CASE("a nested spec brings its bodies, loses its joints, and keeps the deeper ones") {
  const TemporaryFolder folder;
  folder.Write("arm.yaml",
               "mjforge: 1\nname: arm\nparams: {length: 1 .. 2}\n"
               "parts: [{name: base, type: sphere, size: 0.1}]\n"
               "joints: [{name: swing, type: hinge}]\n"
               "bodies:\n"
               "- {name: hand, pos: [length, 0, 0], joints: [{name: wrist}],\n"
               "   parts: [{name: palm, type: sphere, size: 0.1}]}\n"
               "contact: {exclude: [[arm, hand]]}\n"
               "mjcf:\n"
               "  sensor:\n"
               "  - {jointpos: {name: angle, joint: wrist}}\n"
               "  - {jointpos: {name: lost, joint: swing}}\n");
  const Assembling thing(
      "bodies:\n"
      "- {name: left, spec: arm.yaml, params: {length: 1.5}, pos: [0, left.length, 0]}\n"
      "- {name: right, spec: arm.yaml, parent: left_hand}\n"
      "joints: none\n",
      1, 0, folder.path());
  const auto& bodies = thing.object().bodies;
  REQUIRE(bodies.size() == 5);
  CHECK(bodies[1].name == "thing_left");
  CHECK(bodies[1].joints.empty());
  CHECK(bodies[1].X_PB.p.y() == 1.5);
  CHECK(bodies[1].parts.at(0).name == "thing_left_base");
  CHECK(bodies[2].name == "thing_left_hand");
  CHECK(bodies[2].joints.at(0).name == "thing_left_wrist");
  CHECK(bodies[2].X_PB.p.x() == 1.5);
  CHECK(bodies[3].parent == 2);
  const auto excludes = model::ElementsOf(thing.object(), "contact");
  REQUIRE(excludes.size() == 2);
  CHECK(model::FindAttribute(excludes[0].attributes, "body1")->text == "thing_left");
  CHECK(model::FindAttribute(excludes[1].attributes, "body2")->text == "thing_right_hand");
  const auto sensors = model::ElementsOf(thing.object(), "sensor");
  REQUIRE(sensors.size() == 2);
  CHECK(sensors[0].name == "thing_left_angle");
  CHECK(model::FindAttribute(sensors[0].attributes, "joint")->text == "thing_left_wrist");
  // The other two are left out, with a warning.
  REQUIRE(thing.raw_findings().size() == 2);
  CHECK(thing.raw_findings()[0].severity == diag::Severity::kWarning);
  CHECK(thing.findings()[0] ==
        "13:36 jointpos 'thing_left_lost' is left out: its joint 'swing' is gone: attaching spec "
        "'arm' removes it");
}

TEST_CASE("names that no element has are reported with the closest one") {
  const std::string bodies =
      "joints: none\nbodies:\n- {name: lid, parts: [{name: g, type: sphere, size: 1}], joints: "
      "[{name: "
      "hinge}]}\n";
  CHECK(OnlyFinding(bodies + "mjcf: {sensor: [{jointpos: {name: q, joint: hing}}]}\n") ==
        "6:45 joint of jointpos 'q' is 'hing', but the object has no joint of that name (did you "
        "mean 'hinge'?)");
  CHECK(OnlyFinding(bodies + "contact: {exclude: [[lid, led]]}\n") ==
        "6:27 body2 of exclude is 'led', but the object has no body of that name (did you mean "
        "'lid'?)");
  CHECK(OnlyFinding(bodies +
                    "mjcf: {sensor: [{framepos: {name: q, objtype: site, objname: lid}}]}\n") ==
        "6:62 objname of framepos 'q' is 'lid', but the object has no site of that name");
}

TEST_CASE("a range in a section holds unless it says otherwise") {
  const Assembling thing(
      "joints: none\nbodies:\n"
      "- {name: a, parts: [{name: g, type: sphere, size: 1}], joints: [{name: j}]}\n"
      "mjcf:\n  actuator:\n"
      "  - {motor: {name: m, joint: j, ctrlrange: [-1, 1]}}\n"
      "  - {motor: {name: n, joint: j, ctrlrange: [-1, 1], ctrllimited: false}}\n");
  const auto motors = model::ElementsOf(thing.object(), "actuator");
  CHECK(model::FindAttribute(motors[0].attributes, "ctrllimited")->text == "true");
  CHECK(model::FindAttribute(motors[1].attributes, "ctrllimited")->text == "false");
}

TEST_CASE("names must differ in the whole object") {
  const Assembling thing(
      "bodies:\n"
      "- {name: a, parts: [{name: g, type: sphere, size: 1}]}\n"
      "- {name: b, parts: [{name: g, type: sphere, size: 1}]}\n");
  CHECK(thing.findings() == std::vector<std::string>{"5:21 two parts are named 'thing_g'"});
  CHECK(thing.raw_findings()[0].notes.at(0).mark.line == 4);
}

TEST_CASE("a body's mass is scaled with all it brings") {
  const Assembling thing(
      "mass: 12\n"
      "bodies:\n"
      "- {name: a, mass: 4, parts: [{name: g, type: sphere, size: 1}, {name: h, type: box, size: "
      "[1, 1, 1]}]}\n"
      "- {name: b, parent: a, mass: a.mass, parts: [{name: k, type: sphere, size: 1}]}\n");
  CHECK(BodyOf(thing, "thing_a").mass_properties.mass == Approx(3));  // the root has the same mass
  CHECK(BodyOf(thing, "thing_b").mass_properties.mass == Approx(6));
  CHECK(thing.object().mass_properties.mass == Approx(12));
}

TEST_CASE("what moves needs a mass, of its own or of what is fixed to it") {
  const std::string moving = "- {name: a, joints: [{name: j}]}\n";
  CHECK(OnlyFinding("joints: none\nbodies:\n" + moving +
                    "- {name: b, parts: [{name: g, type: sphere, size: 1}]}\n") ==
        "5:3 body 'thing_a' can move but has no mass (give one of its parts a mass, or remove its "
        "joints)");
  CHECK_FALSE(Assembling("joints: none\nbodies:\n" + moving +
                         "- {name: b, parent: a, parts: [{name: g, type: sphere, size: 1}]}\n")
                  .failed());
}

TEST_CASE("a free body is one of the world, where its parent has it") {
  const Assembling thing(
      "parts: [{name: plate, type: box, size: [1, 1, 1], mass: 1}]\nbodies:\n"
      "- {name: tray, pos: [0, 0, 2], euler: [0, 0, 90deg],\n"
      "   parts: [{name: g, type: sphere, size: 0.5, mass: 1}]}\n"
      "- {name: ball, parent: tray, joints: free, pos: [3, 0, 0],\n"
      "   parts: [{name: h, type: sphere, size: 0.5, mass: 2}]}\n"
      "- {name: on_ball, parent: ball, pos: [0, 0, 1], joints: [{name: own, type: free}],\n"
      "   parts: [{name: k, type: sphere, size: 0.25, mass: 4}]}\n");
  const model::Body& ball = BodyOf(thing, "thing_ball");
  CHECK(ball.parent == -1);
  CHECK((ball.X_PB.p - Eigen::Vector3d(0, 3, 2)).norm() < 1e-12);
  REQUIRE(ball.joints.size() == 1);
  CHECK(ball.joints[0].name == "thing_ball_joint0");
  CHECK(ball.joints[0].type == "free");
  const model::Body& on_ball = BodyOf(thing, "thing_on_ball");
  CHECK(on_ball.parent == -1);
  CHECK((on_ball.X_PB.p - Eigen::Vector3d(0, 3, 3)).norm() < 1e-12);
  CHECK(on_ball.joints[0].name == "thing_own");
  // Bounds and mass include all bodies.
  CHECK(thing.object().bounds.aabb.max.y() == Approx(3.5));
  CHECK(thing.object().mass_properties.mass == Approx(8));
  CHECK(model::BodyPoses(thing.object())[3].p.z() == Approx(3));
  CHECK(model::Contains(thing.object(), {0, 3.4, 2}));
}

TEST_CASE("what an outer spec says of the start of a joint wins") {
  const TemporaryFolder folder;
  folder.Write("box.yaml",
               "mjforge: 1\nname: box\njoints: [{name: root, type: slide}]\n"
               "parts: [{name: q, type: sphere, size: 1}]\n"
               "bodies: [{name: lid, joints: [{name: hinge, range: [0, 2]}, {name: slip, type: "
               "slide}], parts: [{name: p, type: sphere, size: 1}]}]\n"
               "pose: {hinge: 1, root: 3, slip: 0.5}\n");
  const Assembling thing(
      "joints: none\nbodies:\n- {name: left, spec: box.yaml}\npose: {left_hinge: 2}\n", 1, 0,
      folder.path());
  const model::Body& lid = BodyOf(thing, "thing_left_lid");
  CHECK(lid.joints[0].start == sample::Numbers{2.0});
  CHECK(lid.joints[1].start == sample::Numbers{0.5});
}

TEST_CASE("a spec that stays free keeps what refers to its joint") {
  const TemporaryFolder folder;
  folder.Write("ball.yaml",
               "mjforge: 1\nname: ball\nparts: [{name: p, type: sphere, size: 1}]\n"
               "mjcf: {sensor: [{framepos: {name: at, objtype: body, objname: ball}}, "
               "{user: {name: moved, objtype: joint, objname: joint0, dim: 1}}]}\n");
  const auto sensors = [&](const std::string& joints) {
    const Assembling thing(
        "parts: [{name: q, type: box, size: [1, 1, 1]}]\n"
        "bodies: [{name: left, spec: ball.yaml" +
            joints + "}]\n",
        1, 0, folder.path());
    return model::ElementsOf(thing.object(), "sensor").size();
  };
  CHECK(sensors(", joints: free") == 2);
  CHECK(sensors("") == 1);
}

TEST_CASE("what a nested spec leaves free is free, too") {
  const TemporaryFolder folder;
  folder.Write("set.yaml",
               "mjforge: 1\nname: set\nparts: [{name: board, type: box, size: [1, 1, 1]}]\n"
               "bodies: [{name: peg, joints: free, pos: [2, 0, 0], parts: [{name: p, type: "
               "sphere, size: 1}]}]\n");
  const Assembling thing("bodies:\n- {name: left, spec: set.yaml, pos: [0, 5, 0]}\n", 1, 0,
                         folder.path());
  CHECK((BodyOf(thing, "thing_left_peg").X_PB.p - Eigen::Vector3d(2, 5, 0)).norm() < 1e-12);
  CHECK(BodyOf(thing, "thing_left_peg").parent == -1);
}

TEST_CASE("a body that is free cannot stand on one that moves") {
  CHECK(
      OnlyFinding("joints: none\nbodies:\n- {name: drawer, joints: [{name: slide, type: slide}], "
                  "parts: [{name: "
                  "d, type: sphere, size: 1}]}\n- {name: pen, parent: drawer, joints: free, parts: "
                  "[{name: p, type: sphere, size: 1}]}\n") ==
      "6:3 body 'thing_pen' is free, but stands on body 'thing_drawer', which moves (a free body "
      "is one of the world: its parent may be fixed to the root, or free itself)");
  CHECK(OnlyFinding("joints: none\nbodies:\n- {name: a, parts: [{name: g, type: sphere, size: "
                    "1}],\n   joints: "
                    "[{name: j, type: free}, {name: k}]}\n") ==
        "6:13 free joint 'thing_j' is not the only joint of its body (a free joint already allows "
        "every motion)");
}

TEST_CASE("placement: corner puts bodies of the root by their own lower corner") {
  const Assembling thing(
      "placement: corner\ntotal_size: [1, 1, 1]\n"
      "bodies:\n"
      "- {name: a, parts: [{name: g, type: box, size: [0.1, 0.2, 0.3]}]}\n"
      "- {name: b, euler: [0, 0, 90deg], parts: [{name: h, type: box, size: [0.1, 0.2, 0.3]}]}\n"
      "- {name: c, parent: b, pos: [0, 0, 0.5], parts: [{name: k, type: box, size: [0.1, 0.2, "
      "0.3]}]}\n");
  CHECK((BodyOf(thing, "thing_a").X_PB.p - Eigen::Vector3d(-0.9, -0.8, -0.7)).norm() < 1e-12);
  CHECK((BodyOf(thing, "thing_b").X_PB.p - Eigen::Vector3d(-0.8, -0.9, -0.7)).norm() < 1e-12);
  CHECK((BodyOf(thing, "thing_c").X_PB.p - Eigen::Vector3d(0, 0, 0.5)).norm() < 1e-12);
}

TEST_CASE("equal materials of attached specs are one") {
  const TemporaryFolder folder;
  folder.Write("knob.yaml",
               "mjforge: 1\nname: knob\nparams: {red: 0.5}\n"
               "materials: {paint: {rgba: [red, 0, 0, 1], texture: {builtin: flat}}}\n"
               "parts: [{name: g, type: sphere, size: 0.1, material: paint}]\n");
  const Assembling thing(
      "bodies:\n"
      "- {name: a, spec: knob.yaml}\n"
      "- {name: b, spec: knob.yaml}\n"
      "- {name: c, spec: knob.yaml, params: {red: 0.7}}\n",
      1, 0, folder.path());
  REQUIRE(thing.object().materials.size() == 2);
  CHECK(thing.object().textures.size() == 1);
  CHECK(thing.object().materials[0].name == "thing_a_paint");
  CHECK(thing.object().materials[1].name == "thing_c_paint");
}

TEST_CASE("a draw in a body is keyed by its path alone") {
  const auto height = [](const std::string& before) {
    const Assembling thing("bodies:\n" + before +
                           "- {name: b, pos: [0, 0, 0 .. 1], parts: [{name: h, type: sphere, size: "
                           "1}]}\n");
    return BodyOf(thing, "thing_b").X_PB.p.z();
  };
  CHECK(height("") == height("- {name: a, pos: [0, 0, 0 .. 1]}\n"));
}

}  // namespace mjforge::assemble
