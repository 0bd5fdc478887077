// Comparison of attached geoms, cameras, lights, and sections with their references.

#include "mjforge/validate/compare.h"

#include <functional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "jointed.h"
#include "mjforge/validate/validate.h"

namespace mjforge::validate {
namespace {

using jointed::AddElement;
using jointed::Line;
using jointed::Refers;
using spec::Applies;

model::Element Child(std::string_view tag, std::vector<model::Attribute> attributes) {
  model::Element element;
  element.tag = tag;
  element.attributes = std::move(attributes);
  return element;
}

void AddSite(model::Object& object, std::size_t body, const std::string& name) {
  model::Site& site = object.bodies[body].sites.emplace_back();
  site.name = name;
  site.mark = Line(9);
}

void AddContacts(model::Object& object) {
  AddElement(object, "contact", "pair", "m_pair2", 100).attributes = {
      Refers("geom1", "b_ball", "geom"), Refers("geom2", "block_core", "geom")};
  AddElement(object, "contact", "exclude", "m_exclude", 101).attributes = {
      Refers("body1", "b", "body"), Refers("body2", "a", "body")};
  AddElement(object, "contact", "pair", "m_pair1", 102).attributes = {
      Refers("geom1", "block_core", "geom"), Refers("geom2", "a_ball", "geom")};
  AddElement(object, "contact", "exclude", "", 103).attributes = {Refers("body1", "block", "body"),
                                                                  Refers("body2", "a", "body")};
}

void AddEqualitiesAndTendons(model::Object& object) {
  AddElement(object, "equality", "joint", "m_gear", 110).attributes = {
      Refers("joint1", "a_joint", "joint"), Refers("joint2", "b_joint", "joint")};
  AddElement(object, "equality", "connect", "m_pin", 111).attributes = {
      Refers("body1", "a", "body"), Refers("body2", "b", "body"),
      hand_made::Numbers("anchor", Applies::kBoth, {0, 0, 0})};
  AddElement(object, "equality", "weld", "", 112).attributes = {Refers("body1", "b", "body")};
  AddElement(object, "equality", "tendon", "m_tie", 113).attributes = {
      Refers("tendon1", "m_rope", "tendon"), Refers("tendon2", "m_sum", "tendon")};

  AddElement(object, "tendon", "spatial", "m_rope", 120).children = {
      Child("site", {Refers("site", "s0", "site")}),
      Child("geom", {Refers("geom", "a_ball", "geom"), Refers("sidesite", "s2", "site")}),
      Child("site", {Refers("site", "s1", "site")}),
      Child("pulley", {hand_made::Numbers("divisor", Applies::kBoth, {2})}),
      Child("site", {Refers("site", "s0", "site")}),
      Child("site", {Refers("site", "s2", "site")})};
  AddElement(object, "tendon", "fixed", "m_sum", 121).children = {
      Child("joint",
            {Refers("joint", "a_joint", "joint"), hand_made::Numbers("coef", Applies::kBoth, {1})}),
      Child("joint", {Refers("joint", "b_joint", "joint"),
                      hand_made::Numbers("coef", Applies::kBoth, {-1})})};
}

void AddActuatorsAndSensors(model::Object& object) {
  AddElement(object, "actuator", "motor", "m_motor", 131).attributes = {
      Refers("joint", "a_joint", "joint")};
  AddElement(object, "actuator", "motor", "m_thrust", 132).attributes = {
      Refers("site", "s1", "site"), Refers("refsite", "s2", "site")};
  AddElement(object, "actuator", "position", "m_crank", 133).attributes = {
      Refers("cranksite", "s1", "site"), Refers("slidersite", "s2", "site"),
      hand_made::Numbers("cranklength", Applies::kBoth, {1})};
  AddElement(object, "actuator", "adhesion", "m_glue", 134).attributes = {
      Refers("body", "b", "body"), hand_made::Numbers("ctrlrange", Applies::kBoth, {0, 1})};
  // Actuators with a state must be last.
  AddElement(object, "actuator", "muscle", "m_muscle", 135).attributes = {
      Refers("tendon", "m_rope", "tendon"),
      hand_made::Numbers("lengthrange", Applies::kBoth, {0.1, 1})};

  AddElement(object, "sensor", "jointpos", "m_angle", 140).attributes = {
      Refers("joint", "b_joint", "joint")};
  model::Element& frame = AddElement(object, "sensor", "framepos", "m_frame", 141);
  frame.attributes = {
      hand_made::Word("objtype", Applies::kBoth, "xbody"), Refers("objname", "b", "@objtype"),
      hand_made::Word("reftype", Applies::kBoth, "geom"), Refers("refname", "a_ball", "@reftype")};
  AddElement(object, "sensor", "touch", "", 142).attributes = {Refers("site", "s1", "site")};
  AddElement(object, "sensor", "actuatorfrc", "m_force", 143).attributes = {
      Refers("actuator", "m_glue", "actuator")};
  AddElement(object, "sensor", "subtreecom", "m_com", 144).attributes = {
      Refers("body", "block", "body")};
  AddElement(object, "sensor", "clock", "m_clock", 145);
}

/// A block with two balls, cameras and lights, and an element of every kind.
model::Object Machine() {
  model::Object object = jointed::Block();
  jointed::AddBall(object, "a", 0, {0.1, 0, 0.2}, "hinge", 20);
  jointed::AddBall(object, "b", 0, {-0.1, 0, 0.2}, "slide", 30);
  for (std::size_t i = 0; i < 3; ++i) AddSite(object, i, "s" + std::to_string(i));
  object.bodies[2].sites[0].X_BS.p = {0.03, 0, 0};
  AddContacts(object);
  AddEqualitiesAndTendons(object);
  AddActuatorsAndSensors(object);
  model::Element& camera = object.bodies[1].elements.emplace_back();
  camera.tag = "camera";
  camera.name = "a_eye";
  camera.mark = Line(50);
  model::Element& light = object.bodies[2].elements.emplace_back();
  light.tag = "light";
  light.mark = Line(51);
  object.bodies[2].elements.push_back(camera);
  object.bodies[2].elements.back().name = "b_eye";
  return object;
}

/// Returns the findings if the object is changed after its document was written.
std::vector<std::string> SectionsAfter(const std::function<void(model::Object&)>& change,
                                       model::Object object = Machine(),
                                       mjcf::Target target = mjcf::Target::kMujoco) {
  static Loader loader;
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(object, target, {}, document);
  change(object);
  diag::Findings findings;
  const bool ok = loader.Validate(document, object, findings);
  CHECK(ok == findings.empty());
  std::vector<std::string> messages;
  for (const diag::Finding& finding : findings) {
    messages.push_back(std::to_string(finding.mark.line) + ": " + finding.message);
  }
  return messages;
}

using Messages = std::vector<std::string>;
std::vector<model::Element>& Of(model::Object& object, std::string_view section) {
  for (model::Section& found : object.sections) {
    if (found.info->name == section) return found.elements;
  }
  FAIL("no section " << section);
  return object.sections.front().elements;
}

TEST_CASE("an object with an element of every kind is as meant, in a scene, too") {
  CHECK(SectionsAfter([](model::Object&) {}) == Messages{});
  CHECK(SectionsAfter([](model::Object&) {}, Machine(), mjcf::Target::kScene) == Messages{});
}

TEST_CASE("another number of sensors, actuators, tendons or equalities is found") {
  CHECK(SectionsAfter([](auto& o) { Of(o, "sensor").pop_back(); }) ==
        Messages{"140: MuJoCo compiled 6 elements of sensor, not 5"});
  CHECK(SectionsAfter([](auto& o) { Of(o, "actuator").clear(); }) ==
        Messages{"1: MuJoCo compiled 5 elements of actuator, not 0"});
  CHECK(SectionsAfter([](auto& o) { Of(o, "tendon").pop_back(); }) ==
        Messages{"120: MuJoCo compiled 2 elements of tendon, not 1"});
  CHECK(SectionsAfter([](auto& o) { o.sections.erase(o.sections.begin() + 1); }) ==
        Messages{"1: MuJoCo compiled 4 elements of equality, not 0"});
}

TEST_CASE("another name of an element is found") {
  CHECK(SectionsAfter([](auto& o) { Of(o, "sensor")[0].name = "x"; }) ==
        Messages{"140: MuJoCo compiled sensor 'm_angle' where 'x' was meant"});
  CHECK(SectionsAfter([](auto& o) { o.bodies[1].elements[0].name = "x"; }) ==
        Messages{"50: MuJoCo compiled camera 'a_eye' where 'x' was meant"});
  CHECK(SectionsAfter([](auto& o) { o.bodies[2].elements[0].name = "x"; }) ==
        Messages{"51: MuJoCo compiled light '' where 'x' was meant"});
}

TEST_CASE("another number of cameras or lights is found") {
  CHECK(SectionsAfter([](auto& o) { o.bodies[1].elements.clear(); }) ==
        Messages{"1: MuJoCo compiled 2 cameras, not 1"});
  CHECK(SectionsAfter([](auto& o) { o.bodies[2].elements.erase(o.bodies[2].elements.begin()); }) ==
        Messages{"1: MuJoCo compiled 1 lights, not 0"});
}

TEST_CASE("a sensor or actuator of something else is found") {
  const auto renamed = [](std::string_view section, std::size_t element, std::size_t attribute) {
    return SectionsAfter(
        [=](auto& o) { Of(o, section)[element].attributes[attribute].text = "x"; });
  };
  CHECK(renamed("sensor", 0, 0) ==
        Messages{"140: MuJoCo compiled joint of jointpos 'm_angle' as 'b_joint', not 'x'"});
  CHECK(renamed("sensor", 1, 1) ==
        Messages{"141: MuJoCo compiled objname of framepos 'm_frame' as 'b', not 'x'"});
  CHECK(renamed("sensor", 1, 3) ==
        Messages{"141: MuJoCo compiled refname of framepos 'm_frame' as 'a_ball', not 'x'"});
  CHECK(renamed("sensor", 3, 0) ==
        Messages{"143: MuJoCo compiled actuator of actuatorfrc 'm_force' as 'm_glue', not 'x'"});
  CHECK(renamed("actuator", 0, 0) ==
        Messages{"131: MuJoCo compiled joint of motor 'm_motor' as 'a_joint', not 'x'"});
  CHECK(renamed("actuator", 1, 1) ==
        Messages{"132: MuJoCo compiled refsite of motor 'm_thrust' as 's2', not 'x'"});
  CHECK(renamed("actuator", 2, 0) ==
        Messages{"133: MuJoCo compiled cranksite of position 'm_crank' as 's1', not 'x'"});
  CHECK(renamed("actuator", 2, 1) ==
        Messages{"133: MuJoCo compiled slidersite of position 'm_crank' as 's2', not 'x'"});
  CHECK(renamed("actuator", 3, 0) ==
        Messages{"134: MuJoCo compiled body of adhesion 'm_glue' as 'b', not 'x'"});
  CHECK(renamed("actuator", 4, 0) ==
        Messages{"135: MuJoCo compiled tendon of muscle 'm_muscle' as 'm_rope', not 'x'"});
}

TEST_CASE("another path of a tendon is found") {
  const auto changed = [](std::size_t tendon, std::size_t child, std::size_t attribute) {
    return SectionsAfter(
        [=](auto& o) { Of(o, "tendon")[tendon].children[child].attributes[attribute].text = "x"; });
  };
  CHECK(changed(0, 0, 0) ==
        Messages{"120: MuJoCo compiled site of spatial 'm_rope' as 's0', not 'x'"});
  CHECK(changed(0, 1, 0) ==
        Messages{"120: MuJoCo compiled geom of spatial 'm_rope' as 'a_ball', not 'x'"});
  CHECK(changed(0, 1, 1) ==
        Messages{"120: MuJoCo compiled sidesite of spatial 'm_rope' as 's2', not 'x'"});
  CHECK(changed(1, 1, 0) ==
        Messages{"121: MuJoCo compiled joint of fixed 'm_sum' as 'b_joint', not 'x'"});
  CHECK(SectionsAfter([](auto& o) { Of(o, "tendon")[1].children.pop_back(); }) ==
        Messages{"121: MuJoCo compiled 2 elements of the path of tendon 'm_sum', not 1"});
}

TEST_CASE("an equality of something else is found") {
  const auto renamed = [](std::size_t element, std::size_t attribute) {
    return SectionsAfter(
        [=](auto& o) { Of(o, "equality")[element].attributes[attribute].text = "x"; });
  };
  CHECK(renamed(0, 1) ==
        Messages{"110: MuJoCo compiled joint2 of joint 'm_gear' as 'b_joint', not 'x'"});
  CHECK(renamed(1, 0) == Messages{"111: MuJoCo compiled body1 of connect 'm_pin' as 'a', not 'x'"});
  CHECK(renamed(2, 0) == Messages{"112: MuJoCo compiled body1 of weld '' as 'b', not 'x'"});
  CHECK(renamed(3, 0) ==
        Messages{"113: MuJoCo compiled tendon1 of tendon 'm_tie' as 'm_rope', not 'x'"});
}

TEST_CASE("another pair or exclude is found, whatever their order") {
  CHECK(SectionsAfter([](auto& o) { Of(o, "contact")[0].attributes[0].text = "x"; }) ==
        Messages{"100: MuJoCo compiled no pair for 'x' and 'block_core'"});
  CHECK(SectionsAfter([](auto& o) { Of(o, "contact")[1].attributes[1].text = "x"; }) ==
        Messages{"101: MuJoCo compiled no exclude for 'b' and 'x'"});
  CHECK(SectionsAfter([](auto& o) { Of(o, "contact").pop_back(); }) ==
        Messages{"1: MuJoCo compiled 2 elements of exclude in contact, not 1"});
  CHECK(SectionsAfter([](auto& o) { std::swap(Of(o, "contact")[0], Of(o, "contact")[3]); }) ==
        Messages{});
}

/// A body of an attached file: geoms under their own names.
model::Object Attached() {
  model::Object object = jointed::Block();
  jointed::AddBall(object, "block_lid", 0, {0, 0, 0.2}, "hinge", 20);
  model::Body& body = object.bodies[1];
  body.explicit_inertial = true;
  body.parts[0].as_is = true;
  body.parts[0].attributes = {hand_made::Numbers("group", Applies::kVisual, {2})};
  model::Part look = body.parts[0];
  look.name = "block_lid_look";
  look.role = model::Role::kVisual;
  look.mass = look.density = 0;
  look.mark = Line(25);
  look.attributes = {hand_made::Numbers("contype", Applies::kBoth, {0}),
                     hand_made::Numbers("conaffinity", Applies::kBoth, {0})};
  body.parts.push_back(look);
  body.joints[0].attributes = {hand_made::Numbers("ref", Applies::kBoth, {0.3}),
                               hand_made::Numbers("springref", Applies::kBoth, {0.4}),
                               hand_made::Numbers("solimplimit", Applies::kBoth, {0.8, 0.9, 0.01})};
  return object;
}

TEST_CASE("an attached geom is one geom, with the attributes it has") {
  CHECK(SectionsAfter([](model::Object&) {}, Attached()) == Messages{});
  CHECK(SectionsAfter([](auto& o) { o.bodies[1].parts[0].as_is = false; }, Attached()) ==
        Messages{"1: MuJoCo compiled 4 geoms, not 5"});
  CHECK(SectionsAfter([](auto& o) { o.bodies[1].parts[0].attributes[0].numbers.Change()[0] = 3; },
                      Attached()) ==
        Messages{"21: MuJoCo compiled group of geom 'block_lid_ball' as 2, not 3"});
  CHECK(SectionsAfter([](auto& o) { o.bodies[1].parts[1].name = "x"; }, Attached()) ==
        Messages{"25: MuJoCo compiled geom 'block_lid_look' where 'x' was meant"});
  CHECK(SectionsAfter([](auto& o) { o.bodies[1].parts[0].role = model::Role::kVisual; },
                      Attached()) ==
        Messages{"21: MuJoCo compiled contype of geom 'block_lid_ball' as 1, not 0",
                 "21: MuJoCo compiled conaffinity of geom 'block_lid_ball' as 1, not 0"});
}

TEST_CASE("another attribute of an attached joint is found") {
  const auto changed = [](std::size_t attribute) {
    return SectionsAfter(
        [=](auto& o) { o.bodies[1].joints[0].attributes[attribute].numbers.Change()[0] = 0.5; },
        Attached());
  };
  CHECK(changed(0) ==
        Messages{"22: MuJoCo compiled ref of joint 'block_lid_joint' as 0.3, not 0.5"});
  CHECK(changed(1) ==
        Messages{"22: MuJoCo compiled springref of joint 'block_lid_joint' as 0.4, not 0.5"});
  CHECK(changed(2) ==
        Messages{"22: MuJoCo compiled solimplimit 1 of joint 'block_lid_joint' as 0.8, not 0.5"});
}

}  // namespace
}  // namespace mjforge::validate
