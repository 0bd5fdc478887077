#include "mjforge/attach/compiled_file.h"

#include <string>

#include <catch2/catch.hpp>

#include "attaching.h"

namespace mjforge::attach {
namespace {

const std::string kRack = Mjcf(
    "<frame pos=\"1 0 0\" childclass=\"steel\"><body name=\"rack\"><geom size=\"1\"/>\n"
    "<replicate count=\"11\" offset=\"0.1 0 0\" sep=\"_\"><geom name=\"hook\" size=\"0.01\"/>\n"
    "<body name=\"key\" pos=\"0 0 1\"><joint name=\"swing\"/><geom size=\"0.02\"/></body>\n"
    "</replicate></body></frame>\n",
    "<default><default class=\"steel\"><geom density=\"7800\"/></default></default>\n"
    "<actuator><motor joint=\"swing\"/></actuator>\n");

#if mjVERSION_HEADER >= 315
TEST_CASE("MuJoCo expands frames and replicates of an attached file") {
  Attaching files(kRack);
  const model::Attachment& rack = files.Get("rack");
  CHECK(files.Report().empty());
  REQUIRE(rack.bodies.size() == 12);
  CHECK(rack.bodies[0].parts.size() == 12);
  CHECK(Names(rack.bodies[0].parts).starts_with("rack_geom0 hook_00 hook_01 "));
  CHECK(rack.bodies[0].parts[11].X_BG.p.x() == Approx(1));
  CHECK(rack.bodies[11].name == "key_10");
  CHECK(rack.bodies[11].mark.line == 7);
  CHECK(Names(rack.bodies[11].joints) == "swing_10");
  CHECK(Names(rack.bodies[11].parts) == "key_10_geom0");
  CHECK(rack.bodies[11].parts[0].mark.line == 7);
  REQUIRE(rack.sections.size() == 1);
  CHECK(rack.sections[0].elements.size() == 11);
  CHECK(rack.sections[0].elements[0].name.empty());
}

TEST_CASE("what a frame contains must mean the same in MuJoCo 2.2") {
  Attaching files(Mjcf("<frame><body name=\"b\" gravcomp=\"1\"/></frame>\n"));
  CHECK(files.Try() == nullptr);
  CHECK(files.OnlyFinding().starts_with(
      "error mujoco/later: 'gravcomp' of body 'b' needs MuJoCo 2.3.1"));
}
#else
TEST_CASE("frames and replicates of an attached file are errors that say how to expand them") {
  Attaching files(kRack);
  CHECK(files.Try("rack") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error mujoco/later: the frame on line 5 needs MuJoCo 3.1.2 (the Python package mujoco "
        "3.3.7 expands it: python3 -c \"import mujoco; s = mujoco.MjSpec.from_file('arm.xml'); "
        "[setattr(f, a, '') for f in s.frames for a in ('name', 'childclass')]; s.compile(); "
        "open('arm-flat.xml', 'w').write(s.to_xml())\"; mjforge built with MuJoCo 3.1.2 or later "
        "accepts it) [arm.xml:5:1 here]\n"
        "error mujoco/later: the replicate on line 6 needs MuJoCo 3.1.5 (the same command expands "
        "it; mjforge built with MuJoCo 3.1.5 or later accepts it) [arm.xml:6:1 here]");
}
#endif

}  // namespace
}  // namespace mjforge::attach
