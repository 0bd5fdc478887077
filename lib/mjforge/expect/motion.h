#pragma once

// Private to the room.

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::expect {

/// X_WB of every body with joints at positions, given by full names as qpos has them; joints that
/// are not among them stand where they start. The frame W is where the root is. Equalities between
/// joints are not followed.
std::vector<model::Pose> PosesAt(
    const model::Object& object,
    std::span<const std::pair<std::string, sample::Numbers>> positions);

}  // namespace mjforge::expect
