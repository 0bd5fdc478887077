// Tests of names, frames, welded specs and their order.

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

using Eigen::Vector3d;

TEST_CASE("every element's name begins with the object's") {
  const Assembling thing(
      "parts: [{name: ball, type: sphere, size: [0.1]}]\n"
      "sites: [{name: top}]\n");
  CHECK(thing.object().name == "thing");
  CHECK(thing.body().name == "thing");
  CHECK(thing.body().parts.at(0).name == "thing_ball");
  CHECK(thing.body().sites.at(0).name == "thing_top");
  CHECK(thing.body().joints.at(0).name == "thing_joint0");
}

TEST_CASE("the object can be renamed, and its prefix left out") {
  const std::string body = "parts: [{name: ball, type: sphere, size: [0.1]}]\n";
  const Assembling renamed(body, 1, 0, {}, {.name = "other"});
  CHECK(renamed.body().name == "other");
  CHECK(renamed.body().parts.at(0).name == "other_ball");
  const Assembling bare(body, 1, 0, {}, {.name = {}, .prefix = false});
  CHECK(bare.body().name == "thing");
  CHECK(bare.body().parts.at(0).name == "ball");
  const Assembling bad(body, 1, 0, {}, {.name = "../x"});
  CHECK(bad.findings() ==
        std::vector<std::string>{
            "0:0 object name '../x' is not a valid name (a name is a letter, then "
            "letters, digits and underscores)"});
}

TEST_CASE("children of one element draw from streams of their own") {
  const Assembling thing(
      "parts: [{name: a, type: sphere, size: [1]}]\n"
      "bodies:\n"
      "- name: arm\n"
      "  parts: [{name: b, type: sphere, size: [1], pos: [0, 0, 9]}]\n"
      "  joints: [{name: x, type: slide, axis: [1, 0, 0]}, {name: y, type: slide}]\n"
      "mjcf:\n"
      "  tendon:\n"
      "  - fixed:\n"
      "      name: t\n"
      "      children: [{joint: {joint: x, coef: 1 .. 2}}, {joint: {joint: y, coef: 1 .. 2}}]\n");
  const std::vector<model::Element>& joints = thing.object().sections.at(0).elements.at(0).children;
  REQUIRE(joints.size() == 2);
  CHECK(model::FindAttribute(joints[0].attributes, "coef")->numbers !=
        model::FindAttribute(joints[1].attributes, "coef")->numbers);
  sample::StreamId path = sample::kRootStream;
  for (const char* step : {"thing", "mjcf", "tendon", "t", "joint", "1", "coef"}) {
    path = sample::Child(path, step);
  }
  const double u = sample::Uniforms({.seed = 1, .index = 0}, path)[0];
  CHECK(model::FindAttribute(joints[1].attributes, "coef")->numbers.front() ==
        sample::RoundWithin(1, 2, 1 + u));
}

TEST_CASE("frames of one name in two bodies draw poses of their own") {
  const auto body = [](const std::string& name, const std::string& x) {
    return "- name: " + name + "\n  pos: [" + x +
           ", 0, 0]\n  parts: [{frame: {pos: [0, 0, 0 .. 1]}, name: f, parts: [{name: p_" + name +
           ", type: sphere, size: [1]}]}]\n";
  };
  const Assembling thing("bodies:\n" + body("a", "0") + body("b", "9"));
  const std::vector<model::Body>& bodies = thing.object().bodies;
  REQUIRE(bodies.size() == 3);
  CHECK(bodies[1].parts.at(0).X_BG.p.z() != bodies[2].parts.at(0).X_BG.p.z());
}

TEST_CASE("frames compose with the poses of their parts, rotations included") {
  const Assembling thing(
      "parts:\n"
      "- frame: {pos: [1, 0, 0], euler: [0, 0, 90deg]}\n"
      "  parts:\n"
      "  - frame: {pos: [0, 2, 0], euler: [90deg, 0, 0]}\n"
      "    parts: [{name: a, type: sphere, size: [1], pos: [0, 0, 3]}]\n");
  // (0 0 3) turned by 90 degrees about x is (0 -3 0), then moved (0 -1 0), then turned by 90
  // degrees about z (1 0 0), then moved (2 0 0).
  CHECK((thing.part("thing_a").X_BG.p - Vector3d(2, 0, 0)).norm() < 1e-14);
  CHECK((thing.part("thing_a").X_BG.q * Vector3d::UnitX() - Vector3d(0, 1, 0)).norm() < 1e-14);
}

TEST_CASE("corner placement counts lower corners from the lower corner of the declared box") {
  const Assembling thing(
      "placement: corner\n"
      "total_size: [1, 2, 3]\n"
      "parts:\n"
      "- {name: a, type: box, size: [0.1, 0.2, 0.3], pos: [0, 0, 0]}\n"
      "- {name: b, type: box, size: [0.1, 0.2, 0.3], pos: [0.5, 0, 0], euler: [0, 0, 90deg]}\n"
      "- frame: {pos: [0, 0, 1]}\n"
      "  parts: [{name: c, type: sphere, size: [0.5]}]\n");
  CHECK((thing.part("thing_a").X_BG.p - Vector3d(-0.9, -1.8, -2.7)).norm() < 1e-14);
  CHECK((thing.part("thing_b").X_BG.p - Vector3d(-0.3, -1.9, -2.7)).norm() < 1e-14);
  CHECK((thing.part("thing_c").X_BG.p - Vector3d(-0.5, -1.5, -1.5)).norm() < 1e-14);
  CHECK(thing.object().bounds.declared);
  CHECK(thing.object().bounds.top_offset == 3);
  CHECK(thing.object().bounds.bottom_offset == -3);
  CHECK(thing.object().bounds.horizontal_radius == Approx(std::sqrt(5)));
}

const std::string kInner =
    "mjforge: 1\nname: inner\n"
    "params: {r: 0.1 .. 0.2}\n"
    "require: [r > 0.15]\n"
    "materials: {wood: {density: 500, rgba: [1, 0, 0, 1]}}\n"
    "parts: [{name: ball, type: sphere, size: [r], material: wood}]\n"
    "sites: [{name: top, pos: [0, 0, r]}]\n"
    "joints: [{name: slider, type: slide}]\n";

TEST_CASE("a welded spec brings parts, sites and materials under its entry's name") {
  const TemporaryFolder folder;
  folder.Write("inner.yaml", kInner);
  const Assembling thing(
      "parts:\n"
      "- {name: left, spec: inner.yaml, pos: [1, 0, 0], euler: [0, 90deg, 0], params: {r: 0.2}}\n",
      1, 0, folder.path());
  CHECK(thing.part("thing_left_ball").shape.size.x() == 0.2);
  CHECK(thing.part("thing_left_ball").X_BG.p == Vector3d(1, 0, 0));
  CHECK(thing.object().materials.at(0).name == "thing_left_wood");
  CHECK((thing.body().sites.at(0).X_BS.p - Vector3d(1.2, 0, 0)).norm() < 1e-14);
  REQUIRE(thing.body().joints.size() == 1);  // the inner slide joint is dropped
  CHECK(thing.body().joints[0].type == "free");
}

TEST_CASE("a welded spec's draws meet its own requirements and differ by entry") {
  const TemporaryFolder folder;
  folder.Write("inner.yaml", kInner);
  const std::string left = "- {name: left, spec: inner.yaml}\n";
  const std::string right = "- {name: right, spec: inner.yaml}\n";
  for (std::uint64_t index = 0; index < 20; ++index) {
    const Assembling both("parts:\n" + left + right, 1, index, folder.path());
    const double r_left = both.part("thing_left_ball").shape.size.x();
    const double r_right = both.part("thing_right_ball").shape.size.x();
    CHECK(r_left > 0.15);
    CHECK(r_right > 0.15);
    CHECK(r_left != r_right);
    const Assembling alone("parts:\n" + right, 1, index, folder.path());
    CHECK(alone.part("thing_right_ball").shape.size.x() == r_right);
  }
}

TEST_CASE("a spec welded into a welded spec") {
  const TemporaryFolder folder;
  folder.Write("inner.yaml", kInner);
  folder.Write("middle.yaml",
               "mjforge: 1\nname: middle\nmass: 3\n"
               "parts: [{name: x, spec: inner.yaml, pos: [0, 0, 1]}]\n");
  const Assembling thing(
      "parts: [{name: y, spec: middle.yaml, pos: [0, 1, 0]}, {name: z, type: sphere, size: [1], "
      "mass: 2}]\n",
      1, 0, folder.path());
  const model::Part& ball = thing.part("thing_y_x_ball");
  CHECK(ball.X_BG.p == Vector3d(0, 1, 1));
  CHECK(ball.mass == Approx(3));
  CHECK(ball.density == 0);
  CHECK(thing.object().mass_properties.mass == Approx(5));
}

TEST_CASE("a welded spec is placed by its own lower corner") {
  const TemporaryFolder folder;
  folder.Write("pair.yaml",
               "mjforge: 1\nname: pair\n"
               "parts:\n"
               "- {name: a, type: box, size: [0.1, 0.1, 0.1]}\n"
               "- {name: b, type: box, size: [0.1, 0.1, 0.1], pos: [0, 0, 0.4]}\n");
  const Assembling thing(
      "placement: corner\n"
      "total_size: [1, 1, 1]\n"
      "parts: [{name: p, spec: pair.yaml, pos: [0.2, 0, 0], euler: [180deg, 0, 0]}]\n",
      1, 0, folder.path());
  CHECK((thing.part("thing_p_a").X_BG.p - Vector3d(-0.7, -0.9, -0.5)).norm() < 1e-14);
  CHECK((thing.part("thing_p_b").X_BG.p - Vector3d(-0.7, -0.9, -0.9)).norm() < 1e-14);
}

TEST_CASE("the lower corner of a welded spec includes its bodies") {
  const TemporaryFolder folder;
  folder.Write("lamp.yaml",
               "mjforge: 1\nname: lamp\n"
               "parts: [{name: foot, type: box, size: [0.1, 0.1, 0.1]}]\n"
               "bodies:\n"
               "- {name: arm, pos: [-0.3, 0, 0], joints: [{name: turn, axis: [0, 1, 0]}],\n"
               "   parts: [{name: a, type: box, size: [0.1, 0.1, 0.1]}]}\n"
               "- {name: head, parent: arm, euler: [0, 0, 45deg], pos: [0, 0, -0.5],\n"
               "   parts: [{name: h, type: sphere, size: 0.2}]}\n");
  const Assembling thing(
      "placement: corner\ntotal_size: [1, 1, 1]\n"
      "parts: [{name: first, type: box, size: [0.1, 0.1, 0.1]},\n"
      "        {name: p, spec: lamp.yaml, pos: [0.2, 0, 0]}]\n",
      1, 0, folder.path());
  // The lower corner of the lamp, relative to its foot, is that of the head: (-0.5, -0.2, -0.7).
  CHECK((thing.part("thing_p_foot").X_BG.p - Vector3d(-0.3, -0.8, -0.3)).norm() < 1e-12);
  CHECK((thing.object().bodies[1].X_PB.p - Vector3d(-0.6, -0.8, -0.3)).norm() < 1e-12);
}

TEST_CASE("all errors of an object are found in one go") {
  const Assembling thing(
      "params: {r: -0.01, n: 2.5}\n"
      "parts:\n"
      "- {name: a, type: sphere, size: [r]}\n"
      "- {name: 'b_${i}', for: {i: n}, type: sphere, size: [1]}\n"
      "- {name: c, type: sphere, size: [1], quat: [0, 0, r - r, 0]}\n"
      "joints: [{name: j, axis: [0, 0, 0]}]\n");
  CHECK(thing.failed());
  CHECK(thing.findings() ==
        std::vector<std::string>{
            "5:34 size of part 'a' is -0.01; it must be greater than 0 (it is the value of 'r')",
            "6:29 count of loop 'i' is 2.5; it must be a whole number, 0 or more",
            "7:44 quat of part 'c' is zero",
            "8:26 axis of joint 'j' is zero",
        });
}

TEST_CASE("a name may not come out as something else") {
  CHECK(OnlyFinding("params: {n: 1.5}\n"
                    "parts: [{name: 'a${n}', type: sphere, size: [1]}]\n") ==
        "4:16 part name 'a1.5' is not a valid name (a name is a letter, then letters, digits and "
        "underscores)");
}

TEST_CASE("two parts of one name are an error even after the prefix") {
  CHECK(OnlyFinding("params: {n: 1}\n"
                    "parts:\n"
                    "- {name: 'a${n}', type: sphere, size: [1]}\n"
                    "- {name: a1, type: sphere, size: [1]}\n") ==
        "6:3 two parts are named 'thing_a1'");
}

TEST_CASE("lists of numbers have the lengths that MuJoCo 2.2 requires") {
  const Assembling thing(
      "joints: [{name: a, axis: [0, 0, 1]}]\nparts: [{name: s, type: sphere, size: 1}]\nmjcf:\n"
      "  equality: [{joint: {name: e, joint1: a, polycoef: [0.5, -1]}}]\n"
      "  tendon:\n"
      "    - fixed: {name: t, springlength: [0.1, 0.1], children: [{joint: {joint: a, coef: 1}}]}\n"
      "    - fixed: {name: u, springlength: [0, 0.1], children: [{joint: {joint: a, coef: 1}}]}\n");
  const auto numbers = [&](std::string_view section, std::size_t element, std::string_view name) {
    return model::FindAttribute(model::ElementsOf(thing.object(), section)[element].attributes,
                                name)
        ->numbers;
  };
  CHECK(numbers("equality", 0, "polycoef") == sample::Numbers{0.5, -1, 0, 0, 0});
  CHECK(numbers("tendon", 0, "springlength") == sample::Numbers{0.1});
  CHECK(numbers("tendon", 1, "springlength") == sample::Numbers{0, 0.1});
}

}  // namespace
}  // namespace mjforge::assemble
