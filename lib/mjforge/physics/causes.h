// Texts for findings about faults in a simulation: causes and remedies.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/joint_drive.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {

/// Most probable cause of a simulation that diverges.
struct Divergence {
  std::string cause;  // "the spring of joint 'lid' is too stiff for a timestep of 2 ms"
  std::string hint;
  std::string joint = {};     // name of the joint to blame; empty: none
  std::string actuator = {};  // name of the actuator to blame; empty: none
};

/// Returns the most probable cause of the divergence of the simulation with data `d`: the spring,
/// damper or actuator that exceeds the limit of explicit integration most; if there is none, the
/// deepest penetration at the start; otherwise the joint that MuJoCo's warning names. Resets the
/// data of the workspace, which may be `d`.
Divergence FindDivergence(const mjModel& m, const mjData& d, Workspace& workspace);

/// Returns the hinge or slide that moved most since the start, as ", as joint 'lid' moves by 90
/// deg"; an empty text if no joint moved by 5 deg or 5 mm.
std::string MovedJointText(const mjModel& m, const mjData& d);

/// Returns the hint that lists possible sources of the energy that an object gains as it settles.
std::string EnergySourcesHint(const mjModel& m);

/// Returns the hint for a joint that, without a collision, reached too little of its range. The
/// hint names the equalities and tendons of the joint, and the start pose.
std::string HeldBackHint(const mjModel& m, int joint);

/// Returns true if a hinge or slide other than `joint`, which no equality ties to `joint`, moves
/// one of the two bodies relative to the other. Then `at` in an entry of checks.joints can move
/// that body out of the way.
bool CanOtherJointSeparate(const mjModel& m, int joint, const std::pair<int, int>& bodies);

/// Returns the hint `usual` for a joint that exceeds its range by `beyond`, rad or m. If `beyond`
/// is large, the hint also advises an armature.
std::string LimitHint(const mjModel& m, int joint, double beyond, const std::string& usual);

}  // namespace mjforge::physics
