// Tests of the bounds over the ranges of joints, against random positions.

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "assembling.h"
#include "mjforge/model/model.h"

namespace mjforge::assemble {
namespace {

// Returns the box around the object at random positions of its hinges and slides.
model::Box3 SampledBounds(const model::Object& object, const Eigen::Vector2d& otherwise,
                          int count) {
  std::mt19937_64 random(5);
  model::Box3 box;
  for (int k = 0; k < count; ++k) {
    std::vector<std::pair<std::string, sample::Numbers>> positions;
    for (const model::Body& body : object.bodies) {
      for (const model::Joint& joint : body.joints) {
        const Eigen::Vector2d range = joint.range.value_or(otherwise);
        // The first positions are the ends.
        const double share = k < 2 ? k : std::uniform_real_distribution<>(0, 1)(random);
        if (joint.type == "hinge" || joint.type == "slide")
          positions.emplace_back(joint.name,
                                 sample::Numbers{range[0] + share * (range[1] - range[0])});
      }
    }
    const std::vector<model::Pose> poses = model::SubtreePoses(object.bodies, 0, positions);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      for (const model::Part& part : object.bodies[i].parts)
        box.Add(model::BoundsOf(part.shape, poses[i] * part.X_BG));
    }
  }
  return box;
}

bool Covers(const model::Box3& outer, const model::Box3& inner) {
  return (outer.min.array() <= inner.min.array() + 1e-12).all() &&
         (outer.max.array() >= inner.max.array() - 1e-12).all();
}

void CheckSwept(const std::string& joint, double excess) {
  INFO(joint);
  const Assembling thing(
      "joints: none\n"
      "parts: [{name: base, type: box, size: [0.1, 0.1, 0.1], pos: [0, 0, -0.3]}]\n"
      "bodies:\n"
      "- {name: arm, pos: [0.1, 0.2, 0.3], euler: [10deg, 20deg, 30deg], joints: [" +
      joint +
      "],\n   parts: [{name: a, type: box, size: [0.3, 0.02, 0.1], pos: [0.3, 0.1, 0]},\n"
      "           {name: b, type: cylinder, size: [0.1, 0.2], pos: [0.5, 0, 0.2], euler: [1, 0, "
      "0]}]}\n"
      "- {name: tip, parent: arm, pos: [0.6, 0, 0], parts: [{name: c, type: ellipsoid, size: [0.1, "
      "0.2, 0.05]}]}\n");
  const model::Box3 swept = SweptBounds(thing.object());
  const model::Box3 sampled = SampledBounds(thing.object(), {-3.14159, 3.14159}, 3000);
  CHECK(Covers(swept, sampled));
  CHECK(Covers(swept, thing.object().bounds.aabb));
  const Eigen::Vector3d size = swept.max - swept.min;
  const Eigen::Vector3d least = sampled.max - sampled.min;
  for (int i = 0; i < 3; ++i) CHECK(size[i] <= (1 + excess) * least[i]);
}

TEST_CASE("the box around a hinge or a slide is at most one percent too large") {
  CheckSwept("{name: j, axis: [0, 0, 1], range: [0, 110deg]}", 0.01);
  CheckSwept("{name: j, axis: [0, 0, 1]}", 0.01);
  CheckSwept("{name: j, axis: [1, 2, 3], pos: [0.1, 0.2, 0.3], range: [-20deg, 300deg]}", 0.01);
  CheckSwept("{name: j, axis: [0, 1, 0], range: [0, 2deg]}", 0.01);
  CheckSwept("{name: j, axis: [0, 1, 0], range: [1, 1.5], ref: 1}", 0.01);
  CheckSwept("{name: j, axis: [0, 1, 0], range: [-100, 100]}", 0.01);
  CheckSwept("{name: j, type: slide, axis: [3, 2, 1], range: [-0.1, 0.4]}", 1e-9);
  CheckSwept("{name: j, axis: [0, 1, 0], pos: [100, 0, 0], range: [0, 5deg]}", 0.01);
}

TEST_CASE("the box around several joints contains all their combinations") {
  CheckSwept("{name: j, type: slide, range: [0, 1]}, {name: k, axis: [0, 1, 0], range: [-1, 1]}",
             1);
}

TEST_CASE("without moving joints the box is that of the start") {
  const Assembling thing(
      "parts: [{name: p, type: sphere, size: 1}]\n"
      "bodies: [{name: b, pos: [3, 0, 0], parts: [{name: q, type: sphere, size: 1}]}]\n");
  CHECK(SweptBounds(thing.object()).max == thing.object().bounds.aabb.max);
  CHECK(SweptBounds(thing.object()).min == thing.object().bounds.aabb.min);
}

TEST_CASE("a ball joint turns in all directions, and a slide without range stays at the start") {
  const Assembling ball(
      "joints: none\nparts: [{name: p, type: sphere, size: 1}]\n"
      "bodies: [{name: b, joints: [{name: j, type: ball}], parts: [{name: q, type: sphere, size: "
      "1, "
      "pos: [3, 0, 0]}]}]\n");
  const model::Box3 turned = SweptBounds(ball.object());
  CHECK((turned.min.array() <= -4).all());
  CHECK((turned.max.array() >= 4).all());
  CHECK(turned.max.maxCoeff() < 4.5);
  const Assembling slide(
      "joints: none\nparts: [{name: p, type: sphere, size: 1}]\n"
      "bodies: [{name: b, joints: [{name: j, type: slide, start: 2}], parts: [{name: q, type: "
      "sphere, size: 1}]}]\n");
  CHECK(SweptBounds(slide.object()).max == Eigen::Vector3d(1, 1, 3));
}

}  // namespace
}  // namespace mjforge::assemble
