// Causes of what a simulation shows, and what helps against them, in the words of findings.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/joint_drive.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {

/// Element that makes a simulation diverge.
struct Divergence {
  std::string cause;  // "the spring of joint 'lid' is too stiff for a timestep of 2 ms"
  std::string hint;
  std::string joint;     // name; empty: none
  std::string actuator;  // name; empty: none
};

/// Returns what most probably made the simulation with data `d` diverge: the spring, damper,
/// actuator that is farthest beyond the limit of explicit integration, or the deepest
/// penetration at the start, or else the first degree of freedom that MuJoCo named. Resets the
/// workspace, which may own `d`.
Divergence FindDivergence(const mjModel& m, const mjData& d, Workspace& workspace);

/// Returns ", as joint 'lid' moves by 90 deg" about the hinge or slide that moved most since the
/// start; empty if none moved by 5 deg or 5 mm.
std::string MovedJointText(const mjModel& m, const mjData& d);

/// Returns what may give energy to an object as it settles, as a hint.
std::string EnergySourcesHint(const mjModel& m);

/// Returns what holds back a joint that reached too little of its range without a collision, as a
/// hint: the equalities and tendons of the joint, and the start pose.
std::string HeldBackHint(const mjModel& m, int joint);

/// Returns true if a hinge or slide other than `joint` moves one of the bodies, so that `at` of an
/// entry of checks.joints may keep it out of the way.
bool MayStandElsewhere(const mjModel& m, int joint, const std::pair<int, int>& bodies);

/// Returns the hint for a limit that gives way by `beyond`, rad or m.
std::string LimitHint(const mjModel& m, int joint, double beyond, const std::string& usual);

}  // namespace mjforge::physics
