#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "described.h"

namespace mjforge::parity {

/// The names of the files of tests/reference, without ".json", sorted.
std::vector<std::string> ReferenceNames();

nlohmann::json ReadReference(std::string_view name);

/// What the file says the object is. Conventions that differ for every object
/// are settled here:
/// - groups 0 and 1 (collision, visual) are our roles, in whatever group;
/// - the colour of collision geoms, which nobody sees, is left out;
/// - a visual geom's 1e-8 kg are no mass, as in mujoco_group0_inertia;
/// - a look from a picture file is "textured", whatever the picture;
/// - each `default_site`, a mark that robosuite keeps for itself, is left out;
/// - a child's body is called as the child, without `_main` or `_root`.
/// Poses of bodies are as compiled: robosuite's 0.707 is the root of a half.
Described DescribeReference(const nlohmann::json& reference);

}  // namespace mjforge::parity
