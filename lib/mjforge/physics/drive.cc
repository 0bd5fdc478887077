#include "mjforge/physics/drive.h"

#include <algorithm>
#include <span>
#include <utility>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/driver.h"
#include "mjforge/physics/joint_checks.h"
#include "mjforge/physics/travel.h"

namespace mjforge::physics {
namespace {

// A free body becomes so much heavier that a joint's forces do not move it.
constexpr double kHeld = 1e6;

/// The model without gravity, passive forces, floor and loose roots.
engine::Model Hold(const mjModel& model) {
  engine::Model held(mj_copyModel(nullptr, &model));
  mjModel& m = *held;
  // Springs, friction and actuators have no part in where a joint can go.
  m.opt.disableflags |=
      mjDSBL_GRAVITY | engine::kDisablePassive | mjDSBL_FRICTIONLOSS | mjDSBL_ACTUATION;
  // A step takes damping into account even where passive forces are off.
  std::fill_n(m.dof_damping, m.nv, 0.0);
  for (int i = 0; i < m.njnt; ++i) {
    if (m.jnt_type[i] != mjJNT_FREE) continue;
    const int body = m.jnt_bodyid[i];
    double size = 0;
    for (int geom = 0; geom < m.ngeom; ++geom) {
      if (m.body_rootid[m.geom_bodyid[geom]] == body) size = std::max(size, m.geom_rbound[geom]);
    }
    const double mass = kHeld * m.body_subtreemass[body];
    for (int k = 0; k < 6; ++k)
      m.dof_armature[m.jnt_dofadr[i] + k] += k < 3 ? mass : mass * size * size;
  }
  for (int i = 0; i < m.ngeom; ++i) {
    if (m.geom_bodyid[i] == 0 && m.geom_type[i] == mjGEOM_PLANE)
      m.geom_contype[i] = m.geom_conaffinity[i] = 0;
  }
  return held;
}

}  // namespace

Drives DriveJoints(const mjModel& m, mjData& d, std::string_view object,
                   const model::Checks& checks) {
  Drives drives;
  const JointChecks entries(m, object, checks);
  const std::vector<int> others = entries.Others();
  if (!checks.drive || (others.empty() && checks.joints.empty())) return drives;
  const engine::Model held = Hold(m);
  Driver driver(*held, d);
  const auto begin = [&](std::span<const mjtNum> start, const model::JointCheck* check) {
    driver.Begin(start);
    for (Jam& jam : driver.Jams()) {
      jam.check = check;
      drives.jams.push_back(jam);
    }
  };
  begin(compiled::StartOf(m), nullptr);
  const auto run = [&](std::span<const int> joints, const model::JointCheck* check) {
    for (Driven& driven : driver.Run(joints)) {
      driven.check = check;
      drives.joints.push_back(std::move(driven));
    }
  };
  for (const std::vector<int>& group : GroupsOf(*held, d, driver.couplings(), others))
    run(group, nullptr);
  for (const model::JointCheck& check : checks.joints) {
    if (!check.skip.empty()) continue;
    if (check.positions.empty()) driver.Begin(compiled::StartOf(m));
    if (!check.positions.empty()) begin(entries.StartOf(check), &check);
    run(entries.JointsOf(check), &check);
  }
  std::ranges::stable_sort(drives.joints, {}, &Driven::joint);
  return drives;
}

}  // namespace mjforge::physics
