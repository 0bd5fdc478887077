// Piles: bodies that come to rest in a box, and the faults of piles.
#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "mjforge/physics/pile.h"

namespace mjforge::physics {
namespace {

using model::Body;
using model::Object;
using model::Part;

Part BoxAt(const char* name, const Eigen::Vector3d& half, const Eigen::Vector3d& p, double mass) {
  Part part;
  part.name = name;
  part.shape = {model::GeomType::kBox, half};
  part.X_BG.p = p;
  part.mass = mass;
  return part;
}

// Options with which boxes do not creep on each other.
model::Element Option() {
  model::Element option;
  option.tag = "option";
  option.attributes.resize(3);
  option.attributes[0].name = "cone";
  option.attributes[0].text = "elliptic";
  option.attributes[1].name = "impratio";
  option.attributes[1].numbers = {10};
  option.attributes[2].name = "noslip_iterations";
  option.attributes[2].numbers = {20};
  return option;
}

// A box without a lid, 20 cm wide inside and 15 cm high, with `count` cubes of 4 cm to pile up.
Object Crate(int count, double wall = 0.15) {
  Object object;
  object.name = "crate";
  object.sections.push_back({spec::FindSection("option"), {Option()}});
  Body& root = object.bodies.emplace_back();
  root.name = "crate";
  root.mass_properties.mass = 200;
  root.parts.push_back(BoxAt("floor", {0.11, 0.11, 0.005}, {0, 0, -0.005}, 1));
  const double half = wall / 2;
  root.parts.push_back(BoxAt("left", {0.005, 0.11, half}, {-0.105, 0, half}, 1));
  root.parts.push_back(BoxAt("right", {0.005, 0.11, half}, {0.105, 0, half}, 1));
  root.parts.push_back(BoxAt("front", {0.1, 0.005, half}, {0, -0.105, half}, 1));
  root.parts.push_back(BoxAt("back", {0.1, 0.005, half}, {0, 0.105, half}, 1));
  model::Pile& pile = object.piles.emplace_back();
  pile.at = "crate.inside";
  pile.support = 0;
  pile.region.half_size = {0.1, 0.1};
  pile.region.has_walls = true;
  for (int i = 0; i < count; ++i) {
    Body& cube = object.bodies.emplace_back();
    cube.name = "crate_cube_" + std::to_string(i);
    cube.parts.push_back(BoxAt(("cube_" + std::to_string(i)).c_str(), {0.02, 0.02, 0.02},
                               Eigen::Vector3d::Zero(), 0.05));
    cube.mass_properties.mass = 0.05;
    cube.joints.emplace_back().name = cube.name + "_joint0";
    const double turn = 0.7 * i;
    pile.items.push_back(
        {i + 1,
         Eigen::Quaterniond(Eigen::AngleAxisd(turn, Eigen::Vector3d(1, 0.3 * i, 2).normalized())),
         {std::cos(2.4 * i) * 0.8, std::sin(2.4 * i) * 0.8}});
  }
  return object;
}

TEST_CASE("cubes come to rest in a crate") {
  Object object = Crate(12);
  diag::Findings findings;
  CHECK(PileSettler().Settle(object, findings));
  for (const diag::Finding& finding : findings) UNSCOPED_INFO(finding.message);
  CHECK(findings.empty());
  for (std::size_t i = 1; i < object.bodies.size(); ++i) {
    const Eigen::Vector3d& p = object.bodies[i].X_PB.p;
    CHECK(p.head<2>().cwiseAbs().maxCoeff() < 0.1);
    CHECK(p.z() > 0.018);
    CHECK(p.z() < 0.15);
  }
}

TEST_CASE("a pile does not depend on the piles before it") {
  PileSettler settler;
  diag::Findings findings;
  Object first = Crate(5);
  Object between = Crate(7);
  Object again = Crate(5);
  for (Object* object : {&first, &between, &again}) settler.Settle(*object, findings);
  for (std::size_t i = 0; i < first.bodies.size(); ++i) {
    CHECK(first.bodies[i].X_PB.p == again.bodies[i].X_PB.p);
    CHECK(first.bodies[i].X_PB.q.coeffs() == again.bodies[i].X_PB.q.coeffs());
  }
}

TEST_CASE("a body that falls out of its region is reported") {
  Object object = Crate(20, 0.002);
  diag::Findings findings;
  CHECK_FALSE(PileSettler().Settle(object, findings));
  REQUIRE_FALSE(findings.empty());
  CHECK(findings.begin()->code == diag::Code::kPhysicsPileLeft);
}

TEST_CASE("a body that lies above the height of its region is reported") {
  Object object = Crate(1);
  object.piles.front().region.height = 0.015;  // less than the centre of a cube on the floor
  diag::Findings findings;
  CHECK_FALSE(PileSettler().Settle(object, findings));
  REQUIRE_FALSE(findings.empty());
  CHECK(findings.begin()->message == "'cube_0' lies above the `height` of 'crate.inside'");
}

TEST_CASE("a pile that needs more time is reported with its fastest body") {
  Object object = Crate(12);
  object.piles.front().time = 0.004;
  diag::Findings findings;
  CHECK_FALSE(PileSettler().Settle(object, findings));
  REQUIRE_FALSE(findings.empty());
  CHECK(findings.begin()->code == diag::Code::kPhysicsPileMoves);
}

TEST_CASE("a heavy body on a light one sinks into it") {
  Object object = Crate(2);
  object.bodies[2].parts[0].mass = object.bodies[2].mass_properties.mass = 200;
  object.piles.front().is_big_first = false;
  for (model::Pile::Item& item : object.piles.front().items) item = {item.body};
  diag::Findings findings;
  CHECK_FALSE(PileSettler().Settle(object, findings));
  REQUIRE_FALSE(findings.empty());
  CHECK(findings[findings.size() - 1].code == diag::Code::kPhysicsPileDeep);
}

}  // namespace
}  // namespace mjforge::physics
