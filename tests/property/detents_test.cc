// Tests that joints with `detent:` snap to the ends of their range in MuJoCo.

#include <string>

#include <mujoco/mujoco.h>
#include <catch2/catch.hpp>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "purity.h"

namespace mjforge::forge {
namespace {

// Two levers of 5 g and 1 kg and a bolt, whose dead centre is not in the middle.
constexpr const char* kDetents =
    "mjforge: 1\n"
    "name: detents\n"
    "joints: none\n"
    "parts: [{name: base, type: box, size: [1cm, 1cm, 1cm]}]\n"
    "bodies:\n"
    "  - name: light\n"
    "    parts: [{name: a, type: capsule, size: [2mm, 8mm], pos: [0, 0, 1cm], mass: 5g}]\n"
    "    joints: [{name: light, axis: [0, 0, 1], range: [-20deg, 20deg], detent: 0.3Nm}]\n"
    "  - name: heavy\n"
    "    parts: [{name: b, type: capsule, size: [1cm, 10cm], pos: [0, 0, 15cm], mass: 1kg}]\n"
    "    joints: [{name: heavy, axis: [0, 0, 1], range: [0, 60deg], detent: 2Nm}]\n"
    "  - name: bolt\n"
    "    parts: [{name: c, type: box, size: [1cm, 1cm, 1cm], pos: [0, 5cm, 0]}]\n"
    "    joints: [{name: bolt, type: slide, axis: [1, 0, 0], range: [0, 3cm], detent: 4N,\n"
    "              springref: 1cm}]\n";

// Returns the position, as a share of the range, of a joint that starts at `from`, is pushed with
// `force` (Nm or N) for a second, and is then left alone for a second. Gravity and contacts are
// off.
double EndOf(mjModel& m, int joint, double from, double force) {
  m.opt.disableflags |= mjDSBL_CONTACT | mjDSBL_GRAVITY;
  const compiled::Data d = compiled::MakeData(m);
  const double lower = m.jnt_range[2 * joint];
  const double length = m.jnt_range[2 * joint + 1] - lower;
  mjtNum* position = d->qpos + m.jnt_qposadr[joint];
  *position = lower + from * length;
  while (d->time < 2) {
    d->qfrc_applied[m.jnt_dofadr[joint]] = d->time < 1 ? force : 0;
    mj_step(&m, d.get());
  }
  return (*position - lower) / length;
}

TEST_CASE("a joint with a detent stays at its ends, and snaps to the other one when pushed") {
  struct Case {
    int joint;
    double holds;   // force that holds it at its lower end, Nm or N
    double centre;  // dead centre as a share of the range
  };
  // At its lower end, the nearer one, the bolt is held by half of 4 N.
  const auto [joint, holds, centre] =
      GENERATE(values<Case>({{0, 0.3, 0.5}, {1, 2, 0.5}, {2, 2, 1.0 / 3}}));
  INFO("joint " << joint);
  const SpecFolder written;
  Loaded loaded = written.Load(kDetents);
  Generator generator(loaded.recipe, loaded.sources, Seeded(1));
  Variant variant;
  generator.Make(0, variant);
  REQUIRE(variant.ok());
  engine::Engine engine;
  const engine::Loaded compiled = engine.LoadText(variant.document.text);
  REQUIRE(compiled.model);
  mjModel& m = *compiled.model;
  CHECK(EndOf(m, joint, 0, 0) == Approx(0).margin(0.002));
  CHECK(EndOf(m, joint, 1, 0) == Approx(1).margin(0.002));
  CHECK(EndOf(m, joint, centre - 0.05, 0) == Approx(0).margin(0.002));
  CHECK(EndOf(m, joint, centre + 0.05, 0) == Approx(1).margin(0.002));
  CHECK(EndOf(m, joint, 0, 0.95 * holds) == Approx(0).margin(0.002));
  CHECK(EndOf(m, joint, 0, 1.15 * holds) == Approx(1).margin(0.002));
}

}  // namespace
}  // namespace mjforge::forge
