#include "mjforge/physics/proportions.h"

#include "examined.h"
#include "mjforge/physics/overlap.h"

namespace mjforge::physics {
namespace {

using model::GeomType;
using Strings = std::vector<std::string>;

Solid Cube(double half, const Eigen::Vector3d& pos, double density = 1000) {
  Solid solid;
  solid.name = "cube";
  solid.shape = {GeomType::kBox, Eigen::Vector3d::Constant(half), nullptr};
  solid.X_BG.p = pos;
  solid.mass = density * model::Volume(solid.shape);
  return solid;
}

/// Of these solids, with the inertia of a cube of 5 cm.
Subject Of(std::vector<Solid> solids) {
  Subject subject;
  RigidBody& body = subject.bodies.emplace_back();
  body.name = "body";
  body.solids = std::move(solids);
  body.masses_known = true;
  body.inertia = Eigen::Vector3d::Constant(1e-3);
  for (const Solid& solid : body.solids) {
    body.mass += solid.mass;
    body.p_BCm += solid.mass * solid.X_BG.p;
    subject.box.Add(model::BoundsOf(solid.shape, solid.X_BG));
  }
  body.p_BCm /= body.mass;
  subject.mass = body.mass;
  return subject;
}

/// The codes of findings, and the share that is counted twice.
std::pair<Strings, double> Check(const Subject& subject, const model::Checks& checks = {}) {
  diag::Findings findings;
  Verdict verdict(checks, findings);
  const double overlap = CheckProportions(subject, verdict);
  Strings codes;
  for (const diag::Finding& finding : findings) codes.emplace_back(diag::CodeName(finding.code));
  return {codes, overlap};
}

TEST_CASE("a plain cube is as things are") {
  const auto [codes, overlap] = Check(Of({Cube(0.05, {0, 0, 0})}));
  CHECK(codes.empty());
  CHECK(overlap == 0);
}

TEST_CASE("mass counted twice is found to a hundredth") {
  // Half of the second is in the first; the third is all in both.
  const Subject subject =
      Of({Cube(0.1, {0, 0, 0}), Cube(0.1, {0.1, 0, 0}, 500), Cube(0.02, {0.05, 0, 0}, 2000)});
  const double first = 8.0;
  const double second = 4.0;
  const double third = 8e-6 * 8 * 2000;
  const Overlap overlap = FindOverlap(subject.bodies[0]);
  CHECK(overlap.mass == Approx(second / 2 + third).margin(0.01 * (second + third)));
  CHECK(overlap.first == 0);
  CHECK(overlap.second == 1);
  const auto [codes, share] = Check(subject);
  CHECK(codes == Strings{"physics/overlap"});
  CHECK(share == Approx((second / 2 + third) / (first + second + third)).margin(0.01));
}

TEST_CASE("solids that meet at a face share nothing") {
  CHECK(FindOverlap(Of({Cube(0.1, {0, 0, 0}), Cube(0.1, {0.2, 0, 0})}).bodies[0]).mass == 0);
}

TEST_CASE("an inertia that no solid has is an error") {
  Subject subject = Of({Cube(0.05, {0, 0, 0})});
  subject.bodies[0].inertia = {1e-3, 1e-3, 2e-3};  // a flat plate: the two together, at most
  CHECK(Check(subject).first.empty());
  subject.bodies[0].inertia = {1e-3, 3e-3, 1e-3};
  CHECK(Check(subject).first == Strings{"physics/inertia"});
  subject.bodies[0].inertia = {1e-3, 0, 1e-3};
  CHECK(Check(subject).first == Strings{"physics/inertia"});
  model::Checks quiet;
  quiet.silenced = {{"physics/inertia", "a point mass"}};
  CHECK(Check(subject, quiet).first.empty());
}

TEST_CASE("densities, of a part where it is known, else of the body") {
  CHECK(Check(Of({Cube(0.05, {0, 0, 0}, 23'000)})).first ==
        Strings{"physics/bulk-density", "physics/density"});
  Subject light = Of({Cube(0.05, {0, 0, 0}, 19), Cube(0.05, {0.1, 0, 0}, 1000)});
  CHECK(Check(light).first == Strings{"physics/density"});
  light.bodies[0].masses_known = false;
  CHECK(Check(light).first.empty());
}

TEST_CASE("thin and slender parts, each at its threshold") {
  Solid sheet = Cube(0.05, {0, 0, 0});
  sheet.shape.size = {0.02, 0.02, 0.00049};
  sheet.mass = 1000 * model::Volume(sheet.shape);
  CHECK(Check(Of({sheet})).first == Strings{"physics/thin"});
  Solid needle = sheet;
  needle.shape.size = {0.00051, 0.00051, 0.0515};
  needle.mass = 1000 * model::Volume(needle.shape);
  CHECK(Check(Of({needle})).first == Strings{"physics/slender"});
  model::Checks loose;
  loose.aspect = 200;
  loose.thickness = 0.0005;
  CHECK(Check(Of({sheet}), loose).first.empty());
  CHECK(Check(Of({needle}), loose).first.empty());
}

TEST_CASE("a part in the air is loose") {
  CHECK(Check(Of({Cube(0.05, {0, 0, 0}), Cube(0.05, {0.1004, 0, 0})})).first.empty());
  CHECK(Check(Of({Cube(0.05, {0, 0, 0}), Cube(0.05, {0.101, 0, 0})})).first ==
        Strings{"physics/loose"});
}

TEST_CASE("a stated centre of mass outside the parts is found in any file") {
  const std::string stated =
      R"(<inertial pos="0.3 0 0" mass="1" diaginertia="0.01 0.01 0.01"/>)" + kCube;
  CHECK(Examine("<body name=\"cart\">" + stated + "</body>").Codes() ==
        Strings{"warning physics/center-of-mass"});
}

}  // namespace
}  // namespace mjforge::physics
