// Coincidences of a variant's numbers from which MuJoCo derives flags of a model.

#pragma once

#include <string>

#include <mujoco/mujoco.h>

#include "mjforge/family/family.h"

namespace mjforge::family {

/// The number of elements of a kind, and their names as in MJCF.
int ElementCount(const mjModel& m, mjtObj kind);
std::string ElementName(const mjModel& m, mjtObj kind, int id);

/// Names of the arrays of flags.
inline constexpr std::string_view kBodyFlags = "body_sameframe";
inline constexpr std::string_view kGeomFlags = "geom_sameframe";
inline constexpr std::string_view kSiteFlags = "site_sameframe";
inline constexpr std::string_view kJointFlags = "jnt_simple";

/// Adds the arrays of flags: a structure::SameFrame of each body, geom and site, and for each joint
/// whether it lets its body be a simple one (body_simple): its anchor is the origin, its axis a
/// coordinate axis.
void AddCoincidences(const mjModel& m, Numbers& numbers);

}  // namespace mjforge::family
