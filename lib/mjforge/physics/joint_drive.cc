// Drive test: drives groups of joints, while joints that are not coupled to them are held.
#include "mjforge/physics/joint_drive.h"

#include <algorithm>
#include <span>
#include <utility>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/held_model.h"
#include "mjforge/physics/joint_checks.h"
#include "mjforge/physics/joint_controller.h"
#include "mjforge/physics/joint_paths.h"

namespace mjforge::physics {
namespace {

/// Returns a HeldModel() without gravity, springs, damping and dry friction, because these do not
/// limit the range of a joint.
engine::Model WeightlessModel(const mjModel& model) {
  engine::Model held = HeldModel(model);
  held->opt.disableflags |= mjDSBL_GRAVITY | engine::kDisablePassive | mjDSBL_FRICTIONLOSS;
  // MuJoCo integrates damping implicitly even if passive forces are disabled.
  std::fill_n(held->dof_damping, held->nv, 0.0);
  return held;
}

}  // namespace

bool RecordDrive(const mjModel& m, mjData& d, std::string_view object, const model::Checks& checks,
                 int joint, FilmRecorder& recorder) {
  const JointChecks entries(m, object, checks);
  if (!entries.CanBeDriven(joint)) return false;
  const auto check = std::ranges::find_if(
      checks.joints, [&](const model::JointCheck& entry) { return entries.Names(entry, joint); });
  const bool has_entry = check != checks.joints.end();
  const engine::Model held = WeightlessModel(m);
  JointController controller(*held, d, CoupledJoints::kDriven);
  if (has_entry && !check->positions.empty())
    controller.Begin(entries.StartOf(*check));
  else
    controller.Begin(compiled::StartOf(m));
  controller.RecordTo(&recorder);
  recorder.Begin();
  controller.Run(has_entry ? entries.JointsOf(*check) : std::vector<int>{joint});
  recorder.Keep();
  return true;
}

DriveResults DriveJoints(const mjModel& m, mjData& d, std::string_view object,
                         const model::Checks& checks) {
  DriveResults drives;
  const JointChecks entries(m, object, checks);
  const std::vector<int> others = entries.Others();
  if (!checks.drive || (others.empty() && checks.joints.empty())) return drives;
  const engine::Model held = WeightlessModel(m);
  JointController controller(*held, d, CoupledJoints::kDriven);
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
