// Drive test: holds everything but the driven joints, and drives them in groups.
#include "mjforge/physics/joint_drive.h"

#include <algorithm>
#include <span>
#include <utility>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/joint_checks.h"
#include "mjforge/physics/joint_controller.h"
#include "mjforge/physics/joint_paths.h"

namespace mjforge::physics {
namespace {

// Armature of a held free body, as a multiple of its mass.
constexpr double kHeldRootMass = 1e6;

/// Returns a copy of the model without gravity, passive forces and floor, whose roots are held.
engine::Model HeldModel(const mjModel& model) {
  engine::Model held(mj_copyModel(nullptr, &model));
  mjModel& m = *held;
  // Springs, friction and actuators do not limit the range of a joint.
  m.opt.disableflags |=
      mjDSBL_GRAVITY | engine::kDisablePassive | mjDSBL_FRICTIONLOSS | mjDSBL_ACTUATION;
  // MuJoCo integrates damping implicitly even if passive forces are disabled.
  std::fill_n(m.dof_damping, m.nv, 0.0);
  for (int i = 0; i < m.njnt; ++i) {
    if (m.jnt_type[i] != mjJNT_FREE) continue;
    const int body = m.jnt_bodyid[i];
    double size = 0;
    for (int geom = 0; geom < m.ngeom; ++geom) {
      if (m.body_rootid[m.geom_bodyid[geom]] == body) size = std::max(size, m.geom_rbound[geom]);
    }
    const double mass = kHeldRootMass * m.body_subtreemass[body];
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

DriveResults DriveJoints(const mjModel& m, mjData& d, std::string_view object,
                         const model::Checks& checks) {
  DriveResults drives;
  const JointChecks entries(m, object, checks);
  const std::vector<int> others = entries.Others();
  if (!checks.drive || (others.empty() && checks.joints.empty())) return drives;
  const engine::Model held = HeldModel(m);
  JointController controller(*held, d);
  const auto begin = [&](std::span<const mjtNum> start, const model::JointCheck* check) {
    controller.Begin(start);
    for (InitialPenetration& penetration : controller.InitialPenetrations()) {
      penetration.check = check;
      drives.initial_penetrations.push_back(penetration);
    }
  };
  begin(compiled::StartOf(m), nullptr);
  const auto run = [&](std::span<const int> joints, const model::JointCheck* check) {
    for (DrivenJoint& driven : controller.Run(joints)) {
      driven.check = check;
      drives.joints.push_back(std::move(driven));
    }
  };
  for (const std::vector<int>& group : IndependentGroups(*held, d, controller.couplings(), others))
    run(group, nullptr);
  for (const model::JointCheck& check : checks.joints) {
    if (!check.skip.empty()) continue;
    if (check.positions.empty()) controller.Begin(compiled::StartOf(m));
    if (!check.positions.empty()) begin(entries.StartOf(check), &check);
    run(entries.JointsOf(check), &check);
  }
  std::ranges::stable_sort(drives.joints, {}, &DrivenJoint::joint);
  return drives;
}

}  // namespace mjforge::physics
