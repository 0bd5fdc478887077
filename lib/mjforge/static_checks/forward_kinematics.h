// Forward kinematics of an object: poses of its bodies at given joint positions.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::static_checks {

/// Returns X_WB of every body. `positions` has full names of joints and their positions as in
/// MuJoCo's qpos; other joints are at their start positions. The frame W is that of the root.
/// Equalities between joints are ignored.
std::vector<model::Pose> PosesAt(
    const model::Object& object,
    std::span<const std::pair<std::string, sample::Numbers>> positions);

}  // namespace mjforge::static_checks
