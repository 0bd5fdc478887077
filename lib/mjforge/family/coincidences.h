// Coincidences of a variant (equal poses, anchors at the origin), from which MuJoCo derives flags.

#pragma once

#include <string>

#include <mujoco/mujoco.h>

#include "mjforge/family/family.h"

namespace mjforge::family {

/// Return the number of elements of a kind, and the name of an element; an empty text if the
/// element has no name.
int ElementCount(const mjModel& m, mjtObj kind);
std::string ElementName(const mjModel& m, mjtObj kind, int id);

/// Names of the arrays of coincidence flags, with one flag for each element of a kind.
inline constexpr std::string_view kBodyFlags = "body_sameframe";
inline constexpr std::string_view kGeomFlags = "geom_sameframe";
inline constexpr std::string_view kSiteFlags = "site_sameframe";
inline constexpr std::string_view kJointFlags = "jnt_simple";

/// Adds the arrays of coincidence flags to `numbers`. The flag of a body, geom or site is a
/// structure::SameFrame. The flag of a joint is 1 if the joint's anchor is the origin and its axis
/// is a coordinate axis, so that the body can be simple (body_simple); otherwise 0.
void AddCoincidences(const mjModel& m, Numbers& numbers);

}  // namespace mjforge::family
