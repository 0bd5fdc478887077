// Findings about bodies that touch each other.
#include "mjforge/validate/self_collisions.h"

#include <string>
#include <vector>

#include <mujoco/mujoco.h>
#include <catch2/catch.hpp>

#include "jointed.h"
#include "mjforge/validate/validate.h"

namespace mjforge::validate {
namespace {

using jointed::AddBall;
using jointed::AddElement;
using jointed::Line;

struct Verdict {
  bool ok = false;
  diag::Findings findings;
};

Verdict Validated(const model::Object& object, mjcf::Target target = mjcf::Target::kMujoco) {
  static Loader loader;
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(object, target, {}, document);
  Verdict verdict;
  verdict.ok = loader.Validate(document, object, verdict.findings);
  CHECK(verdict.ok != verdict.findings.HasErrors());
  return verdict;
}

/// Each finding as "line: code: message".
std::vector<std::string> FindingTexts(const Verdict& verdict) {
  std::vector<std::string> texts;
  for (const diag::Finding& f : verdict.findings) {
    texts.push_back(std::to_string(f.mark.line) + ": " + std::string(diag::CodeName(f.code)) +
                    ": " + f.message);
  }
  return texts;
}
using Strings = std::vector<std::string>;

/// Two balls on hinges above a block, their centres `distance` apart.
model::Object TwoBalls(double distance) {
  model::Object object = jointed::Block();
  AddBall(object, "block_left", 0, {0, 0, 0.1}, "hinge", 20);
  AddBall(object, "block_right", 0, {distance, 0, 0.1}, "hinge", 30);
  return object;
}

TEST_CASE("two bodies that touch are an error at the second") {
  const Verdict verdict = Validated(TwoBalls(0.0188));
  REQUIRE(FindingTexts(verdict) ==
          Strings{"30: mujoco/self-collision: bodies 'block_left' and 'block_right' touch in the "
                  "start pose: geoms 'block_left_ball' and 'block_right_ball', 1.2 mm deep"});
  const diag::Finding& finding = verdict.findings[0];
  CHECK(finding.severity == diag::Severity::kError);
  CHECK(finding.hint == "move them apart, or write `contact: {exclude: [[left, right]]}`");
  REQUIRE(finding.notes.size() == 1);
  CHECK(finding.notes[0].mark == Line(20));
  CHECK(finding.notes[0].message == "'block_left'");
}

TEST_CASE("bodies that do not touch are fine") {
  CHECK(FindingTexts(Validated(TwoBalls(0.0201))).empty());
}

TEST_CASE("a touch without depth is none, unless the spec wants it") {
  // Sixteenths of a metre are exact, so the distance is 0 without rounding.
  model::Object object = TwoBalls(0.125);
  object.bodies[1].parts[0].shape.size.x() = 0.0625;
  object.bodies[2].parts[0].shape.size.x() = 0.0625;
  object.bodies[1].X_PB.p.z() = object.bodies[2].X_PB.p.z() = 0.25;
  for (model::Body& body : object.bodies) {
    for (model::Part& part : body.parts) part.mass = part.density * model::Volume(part.shape);
  }
  hand_made::Weigh(object);
  CHECK(FindingTexts(Validated(object)).empty());
  object.checks.self_collision = 0;
  CHECK(FindingTexts(Validated(object)) ==
        Strings{"30: mujoco/self-collision: bodies 'block_left' and 'block_right' touch in the "
                "start pose: geoms 'block_left_ball' and 'block_right_ball', 0 mm deep"});
}

TEST_CASE("a depth below a hundredth of a millimetre, or below what the spec says, is none") {
  CHECK(FindingTexts(Validated(TwoBalls(0.019992))).empty());
  CHECK(FindingTexts(Validated(TwoBalls(0.019988))).size() == 1);
  model::Object object = TwoBalls(0.0188);
  object.checks.self_collision = 0.00121;
  CHECK(FindingTexts(Validated(object)).empty());
}

TEST_CASE("what an attached file has itself is a warning") {
  model::Object object = TwoBalls(0.0188);
  object.bodies[1].attached = 1;
  CHECK(Validated(object).findings.HasErrors());
  object.bodies[2].attached = 1;
  const Verdict verdict = Validated(object);
  CHECK(verdict.ok);
  CHECK(FindingTexts(verdict).size() == 1);
}

TEST_CASE("a pair of bodies is reported once, by its deepest contact") {
  model::Object object = TwoBalls(0.019);
  object.bodies[2].parts.push_back(hand_made::Solid("block_right_bump", model::GeomType::kSphere,
                                                    {0.01, 0, 0}, {{-0.004, 0, 0}, {1, 0, 0, 0}},
                                                    33));
  hand_made::Weigh(object);
  CHECK(FindingTexts(Validated(object)) ==
        Strings{"30: mujoco/self-collision: bodies 'block_left' and 'block_right' touch in the "
                "start pose: geoms 'block_left_ball' and 'block_right_bump', 5 mm deep"});
}

TEST_CASE("an excluded pair may touch") {
  model::Object object = TwoBalls(0.015);
  model::Element& exclude = AddElement(object, "contact", "exclude", "", 40);
  exclude.attributes = {jointed::Refers("body1", "block_left", "body"),
                        jointed::Refers("body2", "block_right", "body")};
  CHECK(FindingTexts(Validated(object)).empty());
}

TEST_CASE("parts without contacts may touch") {
  model::Object object = TwoBalls(0.015);
  object.bodies[2].parts[0].role = model::Role::kVisual;
  CHECK(FindingTexts(Validated(object)).empty());
}

TEST_CASE("parent and child, also through a fixed body, may touch") {
  model::Object object = jointed::Block();
  AddBall(object, "block_knob", 0, {0, 0, 0.055}, "hinge", 20);
  AddBall(object, "block_fixed", 0, {0, 0.2, 0}, "", 30);
  AddBall(object, "block_arm", 2, {0, -0.15, 0}, "hinge", 40);
  CHECK(FindingTexts(Validated(object)).empty());
}

TEST_CASE("a child that touches its fixed parent is a warning: MuJoCo lets them collide") {
  model::Object object = jointed::Block();
  object.bodies[0].joints.clear();
  AddBall(object, "block_knob", 0, {0, 0, 0.055}, "hinge", 20);
  const Verdict verdict = Validated(object);
  CHECK(verdict.ok);
  REQUIRE(FindingTexts(verdict) ==
          Strings{"20: mujoco/self-collision: bodies 'block' and 'block_knob' touch in the "
                  "start pose: geoms 'block_core' and 'block_knob_ball', 5 mm deep; MuJoCo "
                  "lets parent and child collide because the parent is fixed"});
  CHECK(verdict.findings[0].severity == diag::Severity::kWarning);
  CHECK(verdict.findings[0].hint ==
        "move them apart, or write `contact: {exclude: [[block, knob]]}`");
}

TEST_CASE("under a nameless body, a host's, only what is no parent and child counts") {
  model::Object inner = jointed::Block();
  inner.bodies[0].joints.clear();
  AddBall(inner, "block_knob", 0, {0, 0, 0.055}, "hinge", 20);
  model::Object object;
  object.name = "block";
  object.bodies.emplace_back();
  for (model::Body& body : inner.bodies) {
    ++body.parent;
    object.bodies.push_back(body);
  }
  CHECK(FindingTexts(Validated(object)).empty());
  object.bodies[1].name = "object";
  AddBall(object, "tip", 2, {0, 0, -0.001}, "hinge", 30);
  const Verdict verdict = Validated(object);
  REQUIRE(FindingTexts(verdict) ==
          Strings{"30: mujoco/self-collision: bodies 'object' and 'tip' touch in the start "
                  "pose: geoms 'block_core' and 'tip_ball', 6 mm deep"});
  CHECK(verdict.findings[0].hint ==
        "move them apart, or write `contact: {exclude: [[block, tip]]}`");
}

TEST_CASE("the second of two bodies is the later one in the spec, whatever MuJoCo's order") {
  model::Object object = TwoBalls(0.1);
  // MuJoCo numbers this body before block_right, because it goes depth first.
  AddBall(object, "block_tip", 1, {0.085, 0, 0}, "hinge", 40);
  CHECK(FindingTexts(Validated(object)) ==
        Strings{"40: mujoco/self-collision: bodies 'block_right' and 'block_tip' touch in the "
                "start pose: geoms 'block_right_ball' and 'block_tip_ball', 5 mm deep"});
}

TEST_CASE("the joints' zero is where the file has the bodies, whatever ref says") {
  model::Object object = TwoBalls(0.1);
  object.bodies[2].joints[0].type = "slide";
  object.bodies[2].joints[0].attributes = {hand_made::Numbers("ref", spec::Applies::kBoth, {0.09})};
  CHECK(FindingTexts(Validated(object)).empty());
}

TEST_CASE("a keyframe that repeats the zero configuration leaves the words as they are") {
  model::Object object = TwoBalls(0.0188);
  model::Joint& slide = object.bodies[2].joints[0];
  slide.type = "slide";
  slide.attributes = {hand_made::Numbers("ref", spec::Applies::kBoth, {0.5})};
  slide.start = {0.5};
  CHECK(FindingTexts(Validated(object)) ==
        Strings{"30: mujoco/self-collision: bodies 'block_left' and 'block_right' touch in the "
                "start pose: geoms 'block_left_ball' and 'block_right_ball', 1.2 mm deep"});
}

/// Two balls with centres 18.8 mm apart in the zero configuration, the second on a slide along x
/// that starts at `start`, m.
model::Object SlidingBall(double start) {
  model::Object object = TwoBalls(0.0188);
  object.bodies[2].joints[0].type = "slide";
  object.bodies[2].joints[0].start = {start};
  return object;
}

TEST_CASE("bodies that touch in the zero configuration alone are a warning") {
  const Verdict verdict = Validated(SlidingBall(0.05));
  CHECK(verdict.ok);
  REQUIRE(FindingTexts(verdict) ==
          Strings{"30: mujoco/self-collision: bodies 'block_left' and 'block_right' touch in the "
                  "zero configuration: geoms 'block_left_ball' and 'block_right_ball', 1.2 mm "
                  "deep; a reset without the keyframe begins there"});
  CHECK(verdict.findings[0].severity == diag::Severity::kWarning);
  CHECK(verdict.findings[0].hint ==
        "write `start: zero`, move them apart, or write `contact: {exclude: [[left, right]]}`");
}

TEST_CASE("bodies that touch at the start are an error, wherever the zero configuration is") {
  CHECK(FindingTexts(Validated(SlidingBall(0.001))) ==
        Strings{"30: mujoco/self-collision: bodies 'block_left' and 'block_right' touch in the "
                "start pose: geoms 'block_left_ball' and 'block_right_ball', 0.2 mm deep"});
}

TEST_CASE("a free body is not tested in the zero configuration of other joints") {
  model::Object object = TwoBalls(0.0188);
  object.bodies[1].joints[0].type = "slide";
  object.bodies[1].joints[0].start = {-0.05};
  object.bodies[2].joints[0].type = "free";
  object.bodies[2].parent = -1;
  CHECK(FindingTexts(Validated(object)).empty());
  object.bodies[1].joints[0].start = {0.001};
  CHECK(FindingTexts(Validated(object)).size() == 1);
}

TEST_CASE("where MuJoCo pushes before a touch, the margin is told") {
  model::Object object = TwoBalls(0.0205);
  object.bodies[1].parts[0].attributes = {
      hand_made::Numbers("margin", spec::Applies::kCollision, {0.001})};
  CHECK(FindingTexts(Validated(object)) ==
        Strings{"30: mujoco/self-collision: bodies 'block_left' and 'block_right' touch in the "
                "start pose: geoms 'block_left_ball' and 'block_right_ball', 0.5 mm apart, "
                "within the margin"});
  object.bodies[1].parts[0].attributes.push_back(
      hand_made::Numbers("gap", spec::Applies::kCollision, {0.001}));
  // The gap reduces the distance of contact forces; since MuJoCo 3.9 it is added to the margin.
  CHECK(FindingTexts(Validated(object)).empty() == (mjVERSION_HEADER < 3009000));
}

TEST_CASE("a scene's floor is no body") {
  model::Object object = TwoBalls(0.1);
  CHECK(FindingTexts(Validated(object, mjcf::Target::kScene)).empty());
}

TEST_CASE("of very many pairs the rest is counted, and room for contacts is no second finding") {
  model::Object object = jointed::Block();
  for (int i = 0; i < 40; ++i) {
    AddBall(object, "block_b" + std::to_string(i), 0, {1e-4 * i, 0, 0.2}, "hinge",
            static_cast<std::uint32_t>(100 + 10 * i));
  }
  const Strings texts = FindingTexts(Validated(object));
  REQUIRE(texts.size() == 51);
  CHECK(texts.front().find("110: mujoco/self-collision: bodies 'block_b0' and 'block_b1' touch") ==
        0);
  CHECK(texts.back() ==
        "1: mujoco/self-collision: 730 more pairs of bodies touch in the start pose");
}

TEST_CASE("one pair among a thousand bodies is found") {
  model::Object object = jointed::Block();
  for (int i = 0; i < 1000; ++i) {
    object.bodies.reserve(1001);
    model::Body& body = object.bodies.emplace_back();
    body.name = "block_b" + std::to_string(i);
    body.parent = 0;
    body.X_PB.p = {0.03 * (i % 10), 0.03 * (i / 10 % 10), 0.1 + 0.03 * (i / 100)};
    body.mark = Line(static_cast<std::uint32_t>(100 + i));
    body.parts.push_back(
        hand_made::Solid(body.name + "_ball", model::GeomType::kSphere, {0.01, 0, 0}, {}, 5));
  }
  object.bodies[1000].X_PB.p = object.bodies[1].X_PB.p + Eigen::Vector3d(0.015, 0, 0);
  object.bodies[1000].joints.emplace_back().name = "block_joint";
  object.bodies[1000].joints[0].type = "ball";
  hand_made::Weigh(object);
  CHECK(FindingTexts(Validated(object)).empty());  // fixed to the block: its child and itself
  object.bodies[1].joints.emplace_back().name = "block_joint1";
  object.bodies[1].joints[0].type = "ball";
  CHECK(FindingTexts(Validated(object)) ==
        Strings{"1099: mujoco/self-collision: bodies 'block_b0' and 'block_b999' touch in the "
                "start pose: geoms 'block_b0_ball' and 'block_b999_ball', 5 mm deep"});
}

TEST_CASE("a distance is told in millimetres") {
  CHECK(DepthText(-0.00123456) == "1.23 mm deep");
  CHECK(DepthText(-1.5) == "1500 mm deep");
  CHECK(DepthText(-1e-15) == "0 mm deep");
  CHECK(DepthText(0.002) == "2 mm apart, within the margin");
}

}  // namespace
}  // namespace mjforge::validate
