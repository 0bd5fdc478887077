// Tests that the joints that bundled specs couple follow each other in MuJoCo.

#include <algorithm>
#include <string>

#include <mujoco/mujoco.h>
#include <catch2/catch.hpp>

#include "harness/effort.h"
#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "purity.h"

namespace mjforge::forge {
namespace {

int JointOf(const mjModel& m, std::string_view ending) {
  for (int joint = 0; joint < m.njnt; ++joint) {
    if (compiled::NameOf(m, mjOBJ_JOINT, joint).ends_with(ending)) return joint;
  }
  FAIL("no joint " << ending);
  return -1;
}

/// Turns a screw by 3 rad in 3 s, with a spring of 0.5 Nm/rad and without contacts, holds it for
/// 2 s, and returns the distance that the nut moved, relative to that of the thread. The ranges of
/// the joints give the thread's lead, because the nut is at its end where the screw is.
double DistanceOfNut(mjModel& m, std::string_view screw, std::string_view nut) {
  constexpr double kAngle = 3;        // rad
  constexpr double kStiffness = 0.5;  // Nm/rad
  m.opt.disableflags |= mjDSBL_CONTACT;
  const compiled::Data d = compiled::MakeData(m);
  const int turn = JointOf(m, screw);
  const int slide = JointOf(m, nut);
  const mjtNum* angle = d->qpos + m.jnt_qposadr[turn];
  while (d->time < kAngle + 2) {
    d->qfrc_applied[m.jnt_dofadr[turn]] = kStiffness * (std::min(d->time, kAngle) - *angle);
    mj_step(&m, d.get());
  }
  REQUIRE(*angle == Approx(kAngle).epsilon(0.01));
  const double lead = m.jnt_range[2 * slide + 1] / m.jnt_range[2 * turn + 1];  // m/rad
  return d->qpos[m.jnt_qposadr[slide]] / (lead * *angle);
}

TEST_CASE("nuts of bundled screws follow their threads under gravity") {
  const auto [spec, screw, nut] = GENERATE(table<std::string, std::string, std::string>(
      {{"tools/adjustable_wrench", "_turn", "_opening"},
       {"articulated/jar_with_lid, params: {closure: screw}", "_turn", "_rise"}}));
  const SpecFolder written;
  Loaded loaded = written.Load(
      "mjforge: 1\nname: held\njoints: none\nbodies: [{name: screw, spec: " + spec + "}]\n");
  Generator generator(loaded.recipe, loaded.sources, Seeded(1));
  engine::Engine engine;
  Variant variant;
  for (int index = 0; index < harness::Effort(20); ++index) {
    INFO(spec << ", index " << index);
    generator.Make(static_cast<std::uint64_t>(index), variant);
    REQUIRE(variant.ok());
    const engine::Loaded compiled = engine.LoadText(variant.document.text);
    REQUIRE(compiled.model);
    CHECK(DistanceOfNut(*compiled.model, screw, nut) == Approx(1).epsilon(0.01));
  }
}

TEST_CASE("couplings of bundled specs hold to 1 % as either joint is driven") {
  const std::string spec =
      GENERATE("tools/adjustable_wrench", "articulated/jar_with_lid, params: {closure: screw}",
               "containers/pedal_bin", "tools/gear_pair");
  const SpecFolder written;
  Loaded loaded = written.Load(
      "mjforge: 1\nname: held\njoints: none\nbodies: [{name: coupled, spec: " + spec + "}]\n");
  Options options = Seeded(1);
  options.validation = Validation::kPhysics;
  Generator generator(loaded.recipe, loaded.sources, options);
  Variant variant;
  for (int index = 0; index < harness::Effort(4); ++index) {
    INFO(spec << ", index " << index);
    generator.Make(static_cast<std::uint64_t>(index), variant);
    REQUIRE(variant.record.physics);
    REQUIRE(variant.record.physics->equalities.size() == 1);
    CHECK(variant.record.physics->equalities[0].share < 0.01);
  }
}

}  // namespace
}  // namespace mjforge::forge
