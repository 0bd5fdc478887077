// Contacts and bounds of joint sweeps.
#include "mjforge/validate/joint_sweep.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "jointed.h"
#include "mjforge/validate/validate.h"

namespace mjforge::validate {
namespace {

using harness::TemporaryFolder;

using std::numbers::pi;

/// Returns the sweep of an MJCF file with these bodies.
Sweep SweepOf(const std::string& bodies, const std::string& sections = {}) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "m.xml")
      << "<mujoco model=\"m\"><compiler angle=\"radian\"/><worldbody>" << bodies << "</worldbody>"
      << sections << "</mujoco>";
  static Loader loader;
  diag::Sources sources;
  diag::Findings findings;
  const std::optional<Sweep> sweep = loader.SweepJoints(folder.path() / "m.xml", sources, findings);
  CHECK(findings.empty());
  REQUIRE(sweep);
  return *sweep;
}

std::string Body(const std::string& name, const std::string& pos, const std::string& content) {
  return "<body name=\"" + name + "\" pos=\"" + pos + "\">" + content + "</body>";
}
std::string Joint(const std::string& name, const std::string& attributes) {
  return "<joint name=\"" + name + "\" " + attributes + "/>";
}
std::string Range(const std::string& range) { return " limited=\"true\" range=\"" + range + "\""; }
std::string Ball(const std::string& name, const std::string& pos) {
  return "<geom name=\"" + name + "\" size=\"0.1\" pos=\"" + pos + "\"/>";
}

/// A ball on a slide.
std::string OnSlide(const std::string& name, const std::string& pos, const std::string& joint,
                    const std::string& axis, const std::string& range) {
  return Body(name, pos,
              Joint(joint, "type=\"slide\" axis=\"" + axis + "\"" + Range(range)) +
                  Ball(name + "_ball", "0 0 0"));
}

const std::string kBase = "<freejoint name=\"free\"/><geom name=\"core\" size=\"0.01\"/>";
const std::string kStop = Body("stop", "1 0 0", "<joint/>" + Ball("stop_ball", "0 0 0"));

/// "joint at value: geom1 geom2 depth", to 1e-6.
std::vector<std::string> ContactTexts(const Sweep& sweep) {
  std::vector<std::string> texts;
  for (const Sweep::Contact& c : sweep.contacts) {
    const auto text = [](double x) { return std::to_string(x); };
    texts.push_back(c.joint + " at " + text(c.value) + ": " + c.body1 + "/" + c.geom1 + " " +
                    c.body2 + "/" + c.geom2 + " " + text(c.depth));
  }
  return texts;
}
using Strings = std::vector<std::string>;

void CheckBox(const model::Box3& box, const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  CHECK((box.min - min).norm() < 1e-12);
  CHECK((box.max - max).norm() < 1e-12);
}

TEST_CASE("a slide goes through its range, and its box with it") {
  const Sweep sweep =
      SweepOf(Body("base", "0 0 0",
                   kBase + Body("cart", "0 0 1",
                                Joint("rail", "type=\"slide\" axis=\"1 0 0\"" + Range("-0.5 2")) +
                                    Ball("cart_ball", "0 0 0"))));
  CHECK(sweep.contacts.empty());
  CHECK(sweep.unlimited_slides.empty());
  CheckBox(sweep.aabb, {-0.6, -0.1, -0.01}, {2.1, 0.1, 1.1});
}

TEST_CASE("the deepest contact of two bodies is told with the joint's value there") {
  const std::string cart = Body(
      "cart", "0 0 0",
      Joint("rail", "type=\"slide\" axis=\"1 0 0\"" + Range("0 2")) + Ball("cart_ball", "0 0 0"));
  const Sweep sweep = SweepOf(Body("base", "0 0 -1", kBase + Body("top", "0 0 1", cart)) +
                              Body("wall", "1 0 0", "<freejoint/>" + Ball("wall_ball", "0 0 0")));
  CHECK(ContactTexts(sweep) == Strings{"rail at 1.000000: cart/cart_ball wall/wall_ball 0.200000"});
}

TEST_CASE("a hinge without limits makes a full turn") {
  const Sweep sweep = SweepOf(
      Body("base", "0 0 0",
           kBase + Body("arm", "0 0 0", Joint("turn", "axis=\"0 0 1\"") + Ball("fist", "1 0 0"))));
  CheckBox(sweep.aabb, {-1.1, -1.1, -0.1}, {1.1, 1.1, 0.1});
}

TEST_CASE("a slide without limits is held at its zero, and said") {
  const Sweep sweep = SweepOf(Body(
      "base", "0 0 0",
      kBase + Body("cart", "0 0 1", Joint("rail", "type=\"slide\"") + Ball("cart_ball", "0 0 0"))));
  CHECK(sweep.unlimited_slides == Strings{"rail"});
  CheckBox(sweep.aabb, {-0.1, -0.1, -0.01}, {0.1, 0.1, 1.1});
}

TEST_CASE("a free body stays, and one that moves with its ref starts from there") {
  const Sweep sweep = SweepOf(
      Body("base", "0 0 5",
           kBase + Body("cart", "0 0 0",
                        Joint("rail", "type=\"slide\" axis=\"1 0 0\" ref=\"1\"" + Range("1 2")) +
                            Ball("cart_ball", "0 0 0"))));
  CheckBox(sweep.aabb, {-0.1, -0.1, 4.9}, {1.1, 0.1, 5.1});
}

TEST_CASE("a ball joint turns about several axes up to its range") {
  const auto arm = [](const std::string& range) {
    return Body("base", "0 0 0",
                kBase + Body("arm", "0 0 0",
                             Joint("shoulder", "type=\"ball\"" + range) + Ball("fist", "1 0 0")));
  };
  const Sweep sweep = SweepOf(arm(Range("0 0.5")));
  CheckBox(sweep.aabb, {-0.01, -std::sin(0.5) - 0.1, -std::sin(0.5) - 0.1},
           {1.1, std::sin(0.5) + 0.1, std::sin(0.5) + 0.1});
  CheckBox(SweepOf(arm("")).aabb, {-1.1, -1.1, -1.1}, {1.1, 1.1, 1.1});
}

TEST_CASE("a ball joint's value is the angle from its zero") {
  const std::string arm = Body(
      "arm", "0 0 0", Joint("shoulder", "type=\"ball\"" + Range("0 1")) + Ball("fist", "1 0 0"));
  REQUIRE(2 * std::sin(0.5 / 2) > 0.2);  // no contact half a radian away
  const Sweep sweep = SweepOf(
      Body("base", "0 0 0", kBase + arm) +
      Body("wall", std::to_string(std::cos(0.5)) + " " + std::to_string(std::sin(0.5)) + " 0",
           "<freejoint/>" + Ball("wall_ball", "0 0 0")));
  REQUIRE(sweep.contacts.size() == 1);
  CHECK(sweep.contacts[0].joint == "shoulder");
  CHECK(sweep.contacts[0].value == Approx(0.5));
  CHECK(sweep.contacts[0].depth == Approx(0.2).margin(1e-5));
}

TEST_CASE("only what a joint changes is told of it") {
  // The fingers touch at zero, independently of the tail's joint.
  const Sweep sweep = SweepOf(
      Body("base", "0 0 0",
           kBase +
               Body("left", "-0.05 0 1",
                    Joint("open", "type=\"slide\" axis=\"-1 0 0\"" + Range("0 1")) +
                        Ball("left_ball", "0 0 0")) +
               Body("right", "0.05 0 1",
                    "<joint name=\"r\" axis=\"1 0 0\"" + Range("-1 1") + "/>" +
                        Ball("right_ball", "0 0 0")) +
               Body("tail", "0 0 -1",
                    Joint("wag", "axis=\"0 0 1\"" + Range("-1 1")) + Ball("tail_ball", "0 0 0"))));
  CHECK(ContactTexts(sweep) == Strings{"open at 0.000000: left/left_ball right/right_ball 0.100000",
                                       "r at -1.000000: left/left_ball right/right_ball 0.100000"});
}

TEST_CASE("a contact that takes two joints is told without a joint, and one that takes none") {
  const auto cart = [](const std::string& name, const std::string& x, const std::string& axis) {
    return OnSlide(name, x + " 0 1", name + "_rail", axis + " 0 0", "0 0.5");
  };
  const Sweep two =
      SweepOf(Body("base", "0 0 0", kBase + cart("a", "-0.5", "1") + cart("b", "0.5", "-1")));
  CHECK(ContactTexts(two) == Strings{" at 0.000000: a/a_ball b/b_ball 0.200000"});
  const Sweep none = SweepOf(Body("a", "0 0 0", "<freejoint/>" + Ball("a_ball", "0 0 0")) +
                             Body("b", "0.15 0 0", "<freejoint/>" + Ball("b_ball", "0 0 0")));
  CHECK(ContactTexts(none) == Strings{" at 0.000000: a/a_ball b/b_ball 0.050000"});
}

TEST_CASE("the other joints are at their start") {
  const std::string bodies = Body("base", "0 0 0",
                                  kBase + OnSlide("cart", "0 0 0", "rail", "1 0 0", "0 0.5") +
                                      OnSlide("gate", "0.6 0 0", "lift", "0 0 1", "0 1"));
  const std::string raised =
      "<keyframe><key name=\"m_start\" qpos=\"0 0 0 1 0 0 0 0 0.5\"/></keyframe>";
  CHECK(ContactTexts(SweepOf(bodies)) ==
        Strings{"rail at 0.500000: cart/cart_ball gate/gate_ball 0.100000"});
  CHECK(ContactTexts(SweepOf(bodies, raised)) ==
        Strings{" at 0.000000: cart/cart_ball gate/gate_ball 0.100000"});
}

TEST_CASE("the box holds what several joints reach together, to the corners") {
  const Sweep sweep = SweepOf(
      Body("base", "0 0 0",
           kBase + Body("first", "0 0 1",
                        Joint("x1", "type=\"slide\" axis=\"1 0 0\"" + Range("0 1")) +
                            Ball("first_ball", "0 0 0") +
                            Body("second", "0 0 1",
                                 Joint("x2", "type=\"slide\" axis=\"1 0 0\"" + Range("0 1")) +
                                     Ball("second_ball", "0 0 0")))));
  CheckBox(sweep.aabb, {-0.1, -0.1, -0.01}, {2.1, 0.1, 2.1});
}

TEST_CASE("excluded pairs and the world's geoms are not inside contacts") {
  const std::string bodies =
      "<geom type=\"plane\" size=\"9 9 1\"/>" +
      Body("base", "0 0 0",
           kBase +
               Body("cart", "0 0 0.05",
                    Joint("rail", "type=\"slide\" axis=\"1 0 0\"" + Range("0 2")) +
                        Ball("cart_ball", "0 0 0")) +
               kStop);
  CHECK(ContactTexts(SweepOf(bodies)).size() == 1);
  CHECK(SweepOf(bodies, "<contact><exclude body1=\"cart\" body2=\"stop\"/></contact>")
            .contacts.empty());
}

TEST_CASE("where nothing can collide the box is that of the looks") {
  const Sweep sweep = SweepOf(
      Body("base", "0 0 0",
           "<freejoint/><geom type=\"box\" size=\"1 2 3\" contype=\"0\" conaffinity=\"0\"/>"));
  CheckBox(sweep.aabb, {-1, -2, -3}, {1, 2, 3});
}

TEST_CASE("a model without bodies or joints has an empty sweep") {
  CHECK(SweepOf("").aabb.empty());
  const Sweep fixed = SweepOf(Body("base", "0 0 0", "<geom size=\"1\"/>"));
  CHECK(fixed.contacts.empty());
  CheckBox(fixed.aabb, {-1, -1, -1}, {1, 1, 1});
}

TEST_CASE("many joints go together, too") {
  std::string bodies;
  for (int i = 0; i < 30; ++i) {
    bodies += Body("b" + std::to_string(i), "0 0 " + std::to_string(i),
                   Joint("j" + std::to_string(i), "type=\"slide\" axis=\"1 0 0\"" + Range("0 1")) +
                       Ball("g" + std::to_string(i), "0 0 0"));
  }
  const Sweep sweep = SweepOf(Body("base", "0 0 -1", kBase + bodies));
  CHECK(sweep.contacts.empty());
  CheckBox(sweep.aabb, {-0.1, -0.1, -1.1}, {1.1, 0.1, 28.1});
}

TEST_CASE("an object's box is in the frame of its root") {
  model::Object object = jointed::Block();
  object.bodies[0].X_PB = {{1, 2, 3}, model::FromAxisAngle(Eigen::Vector3d::UnitZ(), pi / 2)};
  jointed::AddBall(object, "block_cart", 0, {0, 0, 0.2}, "slide", 20);
  object.bodies[1].joints[0].range = Eigen::Vector2d(0, 0.3);
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(object, mjcf::Target::kMujoco, {}, document);
  Loader loader;
  diag::Findings findings;
  const std::optional<Sweep> sweep = loader.SweepJoints(document, object, findings);
  REQUIRE(sweep);
  CHECK(findings.empty());
  CheckBox(sweep->aabb, {-0.05, -0.05, -0.05}, {0.31, 0.05, 0.21});
}

TEST_CASE("a model that MuJoCo refuses or warns of is a finding, not a sweep") {
  const TemporaryFolder folder;
  const auto findings_of = [&](const std::string& text) {
    std::ofstream(folder.path() / "m.xml") << text;
    Loader loader;
    diag::Sources sources;
    diag::Findings findings;
    CHECK_FALSE(loader.SweepJoints(folder.path() / "m.xml", sources, findings));
    return findings.size();
  };
  CHECK(findings_of("<mujoco><worldbody><geom/></worldbody></mujoco>") == 1);
  CHECK(findings_of("<mujoco><worldbody><body><joint/><geom size=\"1\"/><body pos=\"nan 0 0\">"
                    "<geom size=\"1\"/></body></body></worldbody></mujoco>") > 0);
}

}  // namespace
}  // namespace mjforge::validate
