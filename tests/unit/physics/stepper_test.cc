// Equality of the steps of Stepper and mj_step.
#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "examined.h"
#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

/// Returns positions and numbers of contacts after each step. Halfway, the first joint is moved.
template <class Step>
std::vector<mjtNum> Follow(mjModel& m, mjData& d, int steps, Step step) {
  std::vector<mjtNum> all;
  for (int i = 0; i < steps; ++i) {
    if (i == steps / 2) d.qpos[0] += 0.3;
    step();
    all.insert(all.end(), d.qpos, d.qpos + m.nq);
    all.push_back(d.ncon);
  }
  return all;
}

/// Checks that contacts occur, and that the steps of Stepper and mj_step are equal to the last bit.
void CheckSame(const std::string& rest, bool works) {
  const engine::Model m = Load(rest);
  const engine::Model other = Load(rest);
  const compiled::Data bare = compiled::MakeData(*m);
  const compiled::Data fast = compiled::MakeData(*other);
  constexpr int kSteps = 600;
  int touches = 0;
  const std::vector<mjtNum> expected = Follow(*m, *bare, kSteps, [&] {
    mj_step(m.get(), bare.get());
    touches += bare->ncon > 0 ? 1 : 0;
  });
  Stepper stepper(*other, *fast);
  const std::vector<mjtNum> followed = Follow(*other, *fast, kSteps, [&] { stepper.Step(); });
  const auto [unlike, found] = std::ranges::mismatch(expected, followed);
  INFO("they differ in number " << unlike - expected.begin() << " of " << expected.size());
  CHECK(unlike == expected.end());
  CHECK(touches > 0);
  CHECK(BroadPhase(*m).works() == (works && engine::kTakesPairs));
  CHECK(other->npair == m->npair);
}

const std::string kFloor = R"(<geom type="plane" size="0 0 1"/>)";

/// A heap of various shapes and contact parameters.
std::string Heap() {
  return R"(
    <body pos="0 0 0.3"><freejoint/>
      <geom type="box" size="0.1 0.05 0.02" friction="0.2" solref="0.005 1" solmix="100"/>
      <geom type="sphere" size="0.03" pos="0.1 0 0.02" priority="1" solimp="0.8 0.9 0.01"/></body>
    <body pos="0.03 0 0.5" euler="20 30 0"><freejoint/>
      <geom type="capsule" size="0.02 0.2" solref="-1000 -50"/><geom type="cylinder" size="0.05 0.01"
      pos="0 0 0.2" margin="0.01" gap="0.005" condim="4"/></body>
    <body pos="0 0.02 0.8"><freejoint/><geom type="ellipsoid" size="0.03 0.05 0.08" solmix="0"/>
      <geom size="0.5" contype="0" conaffinity="0"/></body>)";
}

TEST_CASE("the stepper steps as MuJoCo does") {
  SECTION("a heap on a floor") {
    CheckSame("<worldbody>" + kFloor + Heap() + "</worldbody>", true);
  }
  SECTION("a heap in a box of the world") {
    CheckSame(R"(<worldbody><geom type="box" size="0.3 0.3 0.05"/>)" + Heap() + "</worldbody>",
              true);
  }
  SECTION("one tree that falls, with loose joints") {
    CheckSame("<worldbody>" + kFloor + R"(
      <body pos="0 0 1" euler="30 0 0"><freejoint/><geom type="box" size="0.2 0.2 0.02"/>
        <body pos="0 0 0.05"><joint type="slide" axis="1 0 0" range="-0.1 0.1" limited="true"/>
          <geom type="box" size="0.05 0.05 0.02"/>
          <body pos="0.06 0 0.1"><joint axis="0 1 0"/><geom type="capsule" size="0.01 0.09"/></body>
        </body>
        <body name="post" pos="0.15 0 0.1"><geom type="cylinder" size="0.01 0.08"/></body>
        <body name="arm" pos="0.15 0 0.2"><joint axis="0 1 0"/>
          <geom type="capsule" fromto="0 0 0 -0.3 0 0" size="0.01"/></body>
      </body></worldbody><contact><exclude body1="post" body2="arm"/></contact>)",
              true);
  }
  SECTION("parents that collide with their children") {
    CheckSame(R"(<option><flag filterparent="disable"/></option><worldbody>
      <body><joint type="slide" axis="1 0 0"/><geom size="0.1"/><body pos="0 0 0.3">
      <joint axis="0 1 0" pos="0 0 -0.3"/><geom size="0.22"/></body></body></worldbody>)",
              true);
  }
}

TEST_CASE("the stepper leaves to MuJoCo what it does not cover") {
  SECTION("pairs of the file's own") {
    CheckSame(
        R"(<worldbody><geom name="floor" type="plane" size="0 0 1" contype="0" conaffinity="0"/>
      <body pos="0 0 0.2"><freejoint/><geom name="ball" size="0.1"/></body></worldbody>
      <contact><pair geom1="floor" geom2="ball"/></contact>)",
        false);
  }
  SECTION("planes that move") {
    CheckSame(R"(<worldbody><body><geom type="plane" size="0 0 1"/></body>
      <body pos="0 0 0.2"><freejoint/><geom size="0.1"/></body></worldbody>)",
              false);
  }
  SECTION("steps with several poses") {
    CheckSame(R"(<option integrator="RK4"/><worldbody>)" + kFloor + Heap() + "</worldbody>", true);
  }
}

}  // namespace
}  // namespace mjforge::physics
