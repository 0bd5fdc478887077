// Checks of densities, sizes, inertias, overlap, loose parts and visual parts.
#include "mjforge/static_checks/static_checks.h"

#include <catch2/catch.hpp>

namespace mjforge::static_checks {
namespace {

using model::GeomType;
using model::Part;
using Strings = std::vector<std::string>;

Part Cube(double half, const Eigen::Vector3d& pos, double density = 1000) {
  Part solid;
  solid.name = "cube";
  solid.shape = {GeomType::kBox, Eigen::Vector3d::Constant(half), nullptr};
  solid.X_BG.p = pos;
  solid.mass = density * model::Volume(solid.shape);
  return solid;
}

/// An object with these parts and the inertia of a cube of 5 cm.
model::Object Of(std::vector<Part> solids) {
  model::Object object;
  model::Body& body = object.bodies.emplace_back();
  body.name = "body";
  body.parts = std::move(solids);
  model::MassProperties& mass = body.mass_properties;
  mass.I_Cm_F = 1e-3 * Eigen::Matrix3d::Identity();
  for (const Part& solid : body.parts) {
    mass.mass = mass.mass + solid.mass;
    mass.p_FCm += solid.mass * solid.X_BG.p;
    object.bounds.aabb.Add(model::BoundsOf(solid.shape, solid.X_BG));
  }
  mass.p_FCm /= mass.mass;
  object.mass_properties = mass;
  return object;
}

/// Returns the codes of findings, and the share of the mass that is counted twice.
std::pair<Strings, double> Check(const model::Object& object, const model::Checks& checks = {}) {
  diag::Findings findings;
  Reporter reporter(checks, findings);
  const double overlap = CheckProportions(object, {}, reporter);
  Strings codes;
  for (const diag::Finding& finding : findings) codes.emplace_back(diag::CodeName(finding.code));
  return {codes, overlap};
}

TEST_CASE("a plain cube is as things are") {
  const auto [codes, overlap] = Check(Of({Cube(0.05, {0, 0, 0})}));
  CHECK(codes.empty());
  CHECK(overlap == 0);
}

TEST_CASE("the share of the mass that is counted twice") {
  const auto [codes, share] = Check(Of({Cube(0.1, {0, 0, 0}), Cube(0.1, {0.1, 0, 0}, 500)}));
  CHECK(codes == Strings{"physics/overlap"});
  CHECK(share == Approx(2.0 / 12).margin(0.01));
}

TEST_CASE("an inertia that no solid has is an error") {
  model::Object subject = Of({Cube(0.05, {0, 0, 0})});
  auto inertia = subject.bodies[0].mass_properties.I_Cm_F.diagonal();
  inertia = Eigen::Vector3d(1e-3, 1e-3, 2e-3);  // a flat plate: the two together, at most
  CHECK(Check(subject).first.empty());
  inertia = Eigen::Vector3d(1e-3, 3e-3, 1e-3);
  CHECK(Check(subject).first == Strings{"physics/inertia"});
  inertia = Eigen::Vector3d(1e-3, 0, 1e-3);
  CHECK(Check(subject).first == Strings{"physics/inertia"});
  model::Checks quiet;
  quiet.silenced = {{"physics/inertia", "a point mass"}};
  CHECK(Check(subject, quiet).first.empty());
}

TEST_CASE("densities, of a part where it is known, else of the body") {
  CHECK(Check(Of({Cube(0.05, {0, 0, 0}, 23'000)})).first ==
        Strings{"physics/bulk-density", "physics/density"});
  model::Object light = Of({Cube(0.05, {0, 0, 0}, 19), Cube(0.05, {0.1, 0, 0}, 1000)});
  CHECK(Check(light).first == Strings{"physics/density"});
  for (Part& part : light.bodies[0].parts) part.mass = 0;
  CHECK(Check(light).first.empty());
}

TEST_CASE("thin and slender parts, each at its threshold") {
  Part sheet = Cube(0.05, {0, 0, 0});
  sheet.shape.size = {0.02, 0.02, 0.00049};
  sheet.mass = 1000 * model::Volume(sheet.shape);
  CHECK(Check(Of({sheet})).first == Strings{"physics/thin"});
  Part needle = sheet;
  needle.shape.size = {0.00051, 0.00051, 0.0515};
  needle.mass = 1000 * model::Volume(needle.shape);
  CHECK(Check(Of({needle})).first == Strings{"physics/slender"});
  model::Checks loose;
  loose.aspect = 200;
  loose.thickness = 0.0005;
  CHECK(Check(Of({sheet}), loose).first.empty());
  CHECK(Check(Of({needle}), loose).first.empty());
}

TEST_CASE("what is seen is near what collides") {
  Part decal = Cube(0.01, {0.1, 0, 0});
  decal.role = model::Role::kVisual;
  decal.mass = 0;
  model::Object object = Of({Cube(0.05, {0, 0, 0}), decal});
  CHECK(Check(object).first == Strings{"physics/looks-differ"});
  model::Checks checks;
  checks.look = 1;
  CHECK(Check(object, checks).first.empty());
  object.bodies[0].parts[1].X_BG.p.x() = 0.06 + 0.0866;  // half of the cube's diagonal: 0.08660
  CHECK(Check(object, checks).first.empty());
  object.bodies[0].parts[1].X_BG.p.x() = 0.06 + 0.0867;
  CHECK(Check(object).first == Strings{"physics/far-visual"});
}

TEST_CASE("what is seen has the extent of what collides") {
  for (const bool is_seen : {true, false}) {
    Part longer = Cube(0.05, {0, 0, 0});
    longer.shape.size = {0.05, 0.05, 0.1};
    longer.role = is_seen ? model::Role::kVisual : model::Role::kCollision;
    Part cube = Cube(0.05, {0, 0, 0});
    cube.role = is_seen ? model::Role::kCollision : model::Role::kVisual;
    CHECK(Check(Of({cube, longer})).first == Strings{"physics/looks-differ"});
    model::Checks checks;
    checks.look = 0.3;
    CHECK(Check(Of({cube, longer}), checks).first.empty());
  }
}

TEST_CASE("parts have limits of their own, and others those of all") {
  Part sheet = Cube(0.05, {0, 0, 0});
  sheet.shape.size = {0.02, 0.02, 0.00049};
  sheet.mass = 1000 * model::Volume(sheet.shape);
  sheet.name = "sheet";
  model::Checks checks;
  checks.parts = {{.parts = {"sheet"}, .thickness = 0.0005}};
  CHECK(Check(Of({sheet}), checks).first.empty());
  Part named = sheet;
  named.name = "crate_sheet";
  model::Object crate = Of({named});
  crate.name = "crate";
  for (const char* name : {"sheet", "crate_sheet"}) {
    checks.parts[0].parts = {name};
    CHECK(Check(crate, checks).first.empty());
  }
  checks.parts = {{.parts = {"shet"}, .thickness = 0.0005}};
  CHECK(Check(Of({sheet}), checks).first == Strings{"model/unknown-reference", "physics/thin"});
}

TEST_CASE("what collides is seen") {
  Part hull = Cube(0.05, {0, 0, 0});
  hull.role = model::Role::kCollision;
  Part look = Cube(0.04, {0, 0, 0});
  look.role = model::Role::kVisual;
  look.mass = 0;
  CHECK(Check(Of({hull, look})).first.empty());
  CHECK(Check(Of({hull})).first == Strings{"physics/unseen"});
  hull.as_is = true;  // a geom of a file is visible, unless its group is hidden
  CHECK(Check(Of({hull})).first.empty());
  hull.attributes = {{.name = "group", .numbers = {3}, .text = {}}};
  CHECK(Check(Of({hull})).first == Strings{"physics/unseen"});
}

TEST_CASE("a part in the air is loose") {
  CHECK(Check(Of({Cube(0.05, {0, 0, 0}), Cube(0.05, {0.1004, 0, 0})})).first.empty());
  CHECK(Check(Of({Cube(0.05, {0, 0, 0}), Cube(0.05, {0.101, 0, 0})})).first ==
        Strings{"physics/loose"});
}

}  // namespace
}  // namespace mjforge::static_checks
