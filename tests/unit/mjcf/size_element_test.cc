#include <catch2/catch.hpp>
#include <cmath>
#include <pugixml.hpp>

#include "hand_made.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/spec/mjcf_sections.h"

namespace mjforge::mjcf {
namespace {

/// Returns the size element of an object's file; empty if it has none.
pugi::xml_node SizeOf(const model::Object& object, Target target, pugi::xml_document& parsed) {
  MjcfDocument document;
  WriteMjcf(object, target, {}, document);
  REQUIRE(parsed.load_buffer(document.text.data(), document.text.size()));
  return parsed.child("mujoco").child("size");
}

/// Returns an object of one body with this many balls.
model::Object Balls(int count) {
  model::Object object = hand_made::Empty("pile");
  for (int i = 0; i < count; ++i) {
    object.bodies[0].parts.push_back(hand_made::Solid("g" + std::to_string(i),
                                                      model::GeomType::kSphere, {0.1, 0, 0},
                                                      {{0.2 * i, 0, 0}, {1, 0, 0, 0}}, 3));
  }
  hand_made::Weigh(object);
  return object;
}

TEST_CASE("a scene of few geoms leaves the sizes to MuJoCo, one of many does not") {
  pugi::xml_document parsed;
  CHECK_FALSE(SizeOf(Balls(24), Target::kScene, parsed));
  CHECK(SizeOf(Balls(25), Target::kScene, parsed).attribute("nconmax").as_int() == 100);
}

TEST_CASE("free bodies that lie on an object need room for their contacts, its own geoms do not") {
  model::Object object = Balls(30);
  const model::Object one = hand_made::Mallet();  // two geoms
  const auto add_free = [&](int count) {
    for (int i = 0; i < count; ++i) {
      model::Body& body = object.bodies.emplace_back();
      body.name = "free" + std::to_string(object.bodies.size());
      body.parts = one.bodies[0].parts;
      body.X_PB.p.z() = static_cast<double>(object.bodies.size());  // m; none touches another
      body.joints.emplace_back();
      body.mass_properties = one.bodies[0].mass_properties;
    }
  };
  pugi::xml_document parsed;
  add_free(12);
  CHECK_FALSE(SizeOf(object, Target::kMujoco, parsed));
  add_free(1);
  const pugi::xml_node size = SizeOf(object, Target::kMujoco, parsed);
  CHECK(size.attribute("nconmax").as_int() == 4 * 26);
  CHECK(size.attribute("njmax").as_int() == 4 * 4 * 26 + 500);
  add_free(137);
  CHECK(SizeOf(object, Target::kMujoco, parsed).attribute("nconmax").as_int() == 4 * 300);
  // Few pieces of a dish lie flat.
  object.bodies.resize(3);
  for (int i = 0; i < 40; ++i) object.bodies[1].parts.push_back(object.bodies[1].parts[0]);
  CHECK(SizeOf(object, Target::kMujoco, parsed).attribute("nconmax").as_int() == 42 + 24 + 4 * 2);
  // A joint to the object is no contact.
  for (model::Body& body : object.bodies) body.parent = &body == &object.bodies[0] ? -1 : 0;
  CHECK_FALSE(SizeOf(object, Target::kMujoco, parsed));
}

/// Returns the number of contacts in the size element; 0 if there is none.
int ContactsIn(const model::Object& object) {
  pugi::xml_document parsed;
  return SizeOf(object, Target::kMujoco, parsed).attribute("nconmax").as_int();
}

/// Returns a row of 40 balls, one body, and a board that was placed on all of them.
model::Object BoardOnBalls() {
  model::Object object = Balls(40);
  model::Body& body = object.bodies.emplace_back();
  body.name = "board";
  body.place_name = "pile.surface";
  body.parts.push_back(hand_made::Solid("board", model::GeomType::kBox, {4, 0.1, 0.1},
                                        {{4, 0, 0.2}, {1, 0, 0, 0}}, 3));
  body.joints.emplace_back();
  return object;
}

TEST_CASE("a placed geom that lies on many others needs room for all of these contacts") {
  model::Object object = BoardOnBalls();
  CHECK(ContactsIn(object) == 1.5 * 40 + 50);
  object.bodies[1].X_PB.p.z() = 1;
  CHECK(ContactsIn(object) == 0);
  // The board is above the balls, but the bounding box of the tilted board contains some of them.
  object.bodies[1].X_PB = {{0, 0, 4}, {std::cos(0.3), 0, std::sin(0.3), 0}};
  CHECK(ContactsIn(object) == 0);
}

TEST_CASE("pairs of boxes, and of convex geoms with multiccd, have several contacts") {
  model::Object object = BoardOnBalls();
  for (model::Part& ball : object.bodies[0].parts) ball.shape.type = model::GeomType::kEllipsoid;
  for (model::Part& ball : object.bodies[0].parts) ball.shape.size = {0.1, 0.1, 0.1};
  const int single = ContactsIn(object);
  SECTION("boxes") {
    for (model::Part& part : object.bodies[0].parts) part.shape.type = model::GeomType::kBox;
    CHECK(ContactsIn(object) == single + 1.5 * 24);
  }
  SECTION("multiccd") {
    const spec::SectionInfo* info = spec::FindSection("option");
    model::Element option;
    option.tag = "option";
    model::Element& flag = option.children.emplace_back();
    flag.tag = "flag";
    flag.attributes.push_back({.name = "multiccd", .numbers = {}, .text = "enable"});
    object.sections.push_back({.info = info, .elements = {option}});
    CHECK(ContactsIn(object) == single + 1.5 * 24);
  }
}

TEST_CASE("two placed bodies have at most as many contacts as one of them has geoms") {
  model::Object object = Balls(60);
  model::Body& body = object.bodies.emplace_back();
  body = object.bodies[0];
  body.name = "nested";
  body.place_name = "pile.surface";
  body.joints.emplace_back();
  // All balls of one body touch all balls of the other one.
  for (model::Body& each : object.bodies)
    for (model::Part& part : each.parts) part.X_BG.p.x() = 0;
  CHECK(ContactsIn(object) == 1.5 * 60 + 50);
}

TEST_CASE("a size is one that MuJoCo 2.2 can address") {
  pugi::xml_document parsed;
  const pugi::xml_node size = SizeOf(Balls(1000), Target::kScene, parsed);
  const double rows = size.attribute("njmax").as_double();
  CHECK(rows < 13'000);
  CHECK(12 * rows * rows < 2e9);
  CHECK(4 * size.attribute("nconmax").as_double() <= rows);
}

TEST_CASE("a stack has at most 1 GB, which is less than the square of many rows") {
  const auto stack_of = [](int balls) {
    model::Object object = Balls(balls);
    object.bodies.push_back(object.bodies[0]);
    object.bodies[1].name = "other";
    object.bodies[1].joints.emplace_back();
    pugi::xml_document parsed;
    return SizeOf(object, Target::kMujoco, parsed).attribute("nstack").as_int();
  };
  CHECK(stack_of(500) == 0);
  CHECK(stack_of(3000) == 120'000'000 + 2 * 2);
}

}  // namespace
}  // namespace mjforge::mjcf
