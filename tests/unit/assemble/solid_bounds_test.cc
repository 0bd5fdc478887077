// Tests of the bounds of solids: exact ones, whatever the pieces are that collide.

#include <catch2/catch.hpp>
#include <cmath>

#include <fmt/format.h>

#include "assembling.h"
#include "mjforge/model/model.h"

namespace mjforge::assemble {
namespace {

using Eigen::Vector3d;

const std::string kCup = "type: lathe, wall: 2mm, profile: [[0,0],[.03,0],[.035,.08]]";

TEST_CASE("a cup has the same bounds however it is turned about its axis") {
  for (const double turn : {0.0, 1.0, 5.0, 10.0, 33.0, 200.0}) {
    const Assembling thing(
        fmt::format("parts: [{{name: a, {}, euler: [0, 0, {}deg]}}]\n", kCup, turn));
    const model::Bounds& bounds = thing.object().bounds;
    INFO(turn);
    CHECK((bounds.aabb.max.head<2>() - Eigen::Vector2d(.035, .035)).norm() < 1e-12);
    CHECK((bounds.aabb.min - Vector3d(-.035, -.035, 0)).norm() < 1e-12);
    CHECK(std::abs(bounds.horizontal_radius - .035) < 1e-12);
    CHECK((bounds.swept.max - bounds.aabb.max).norm() == 0);
  }
}

TEST_CASE("a lying cup is as high as its circles, in any role") {
  for (const std::string role : {"both", "collision", "visual"}) {
    for (const double turn : {0.0, 7.0}) {
      const Assembling thing(
          fmt::format("joints: none\n"
                      "parts:\n- frame: {{euler: [90deg, 0, 0]}}\n"
                      "  parts: [{{name: a, role: {}, {}, euler: [0, 0, {}deg]}}]\n",
                      role, kCup, turn));
      const model::Bounds& bounds = thing.object().bounds;
      INFO(role << " " << turn);
      CHECK(std::abs(bounds.top_offset - .035) < 1e-12);
      CHECK(std::abs(bounds.bottom_offset + .035) < 1e-12);
      CHECK(bounds.horizontal_radius > .08);
    }
  }
}

TEST_CASE("a body's properties are those of its solid") {
  const Assembling thing(
      "bodies:\n"
      "- {name: cup, euler: [0, 90deg, 0], parts: [{name: a, " +
      kCup +
      ", euler: [0, 0, 11deg]}]}\n"
      "- {name: ball, pos: [cup.half_x, cup.half_y, cup.radius], parts: [{name: b, type: sphere, "
      "size: [1]}]}\n");
  const Vector3d p = thing.object().bodies[2].X_PB.p;
  CHECK(std::abs(p.y() - .035) < 1e-12);
  CHECK(std::abs(p.z() - .035) < 1e-12);
}

TEST_CASE("corner placement puts the corner of the true solid there") {
  const auto com = [](const std::string& part) {
    const Assembling thing("placement: corner\ntotal_size: [.05, .05, .05]\nparts: [{name: a, " +
                           part + "}]\n");
    return thing.object().mass_properties.p_FCm;
  };
  CHECK((com(kCup).head<2>() - Eigen::Vector2d(-.015, -.015)).norm() < 1e-12);
  CHECK((com(kCup + ", euler: [0, 0, 10deg]") - com(kCup)).norm() < 1e-12);
  // The core, a box of 21 x 11 x 1 mm, is turned, and all around it are 9 mm.
  const Eigen::Matrix3d R = model::FromEuler(Vector3d(35, 20, 10) * M_PI / 180).toRotationMatrix();
  const Vector3d half = R.cwiseAbs() * Vector3d(.021, .011, .001) + Vector3d::Constant(.009);
  const Vector3d center =
      com("type: box, size: [3cm, 2cm, 1cm], round: 9mm, euler: [35deg, 20deg, 10deg]");
  CHECK((center - (half - Vector3d::Constant(.05))).norm() < 1e-12);
}

TEST_CASE("a cup on a hinge sweeps what its circles sweep") {
  const Assembling thing(
      "joints: none\nbodies: [{name: cup, joints: [{name: j, type: slide, axis: [1, 0, 0], range: "
      "[0, 1]}], "
      "parts: [{name: a, " +
      kCup + ", euler: [0, 0, 11deg]}]}]\n");
  const model::Box3& swept = thing.object().bounds.swept;
  CHECK(std::abs(swept.max.x() - 1.035) < 1e-12);
  CHECK(std::abs(swept.min.x() + .035) < 1e-12);
  const Assembling ball(
      "joints: none\nbodies: [{name: cup, joints: [{name: j, type: ball}], parts: [{name: a, " +
      kCup + ", euler: [0, 0, 11deg]}]}]\n");
  CHECK(ball.object().bounds.swept.min.z() < -.08);
  CHECK(ball.object().bounds.swept.min.z() > -.11);
}

}  // namespace
}  // namespace mjforge::assemble
