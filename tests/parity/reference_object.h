// Objects of robosuite, described for comparison.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "described.h"

namespace mjforge::parity {

/// Returns the names of the files of tests/reference, without ".json", sorted.
std::vector<std::string> ReferenceNames();

nlohmann::json ReadReference(std::string_view name);

/// Describes the object of a reference file, and converts the conventions that differ for every
/// object:
/// - groups 0 and 1 become the roles collision and visual;
/// - the invisible colour of collision geoms is omitted;
/// - the 1e-8 kg of a visual geom count as no mass, as in mujoco_group0_inertia;
/// - a look from any picture file is "textured";
/// - each `default_site`, which only robosuite uses, is omitted;
/// - a child's body has the child's name, without `_main` or `_root`.
/// Poses of bodies are those of the compiled model, where robosuite's 0.707 is sqrt(1/2).
Described DescribeReference(const nlohmann::json& reference);

}  // namespace mjforge::parity
