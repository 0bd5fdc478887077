// Flags for special poses of a variant's elements: frames that MuJoCo treats as equal (sameframe),
// and joints that allow a simple body (body_simple).

#pragma once

#include <string>

#include <mujoco/mujoco.h>

#include "mjforge/family/family.h"

namespace mjforge::family {

/// Return the number of elements of a kind, and the name of an element; an empty text if the
/// element has no name.
int ElementCount(const mjModel& m, mjtObj kind);
std::string ElementName(const mjModel& m, mjtObj kind, int id);

/// Names of the arrays of flags for special poses. Each array has one flag per element, except for
/// the world body. The first three arrays correspond to mjModel's arrays with these names; mjModel
/// has no `jnt_simple`.
inline constexpr std::string_view kBodyFlags = "body_sameframe";
inline constexpr std::string_view kGeomFlags = "geom_sameframe";
inline constexpr std::string_view kSiteFlags = "site_sameframe";
inline constexpr std::string_view kJointFlags = "jnt_simple";

/// Adds the arrays of flags for special poses to `numbers`. The flag of a body, geom or site is a
/// structure::SameFrame. The flag of a joint is 1 if the joint allows a simple body (body_simple),
/// otherwise 0. Joints that allow a simple body are free joints, ball joints whose anchor is the
/// body's origin, and hinges and slides whose anchor is the origin and whose axis is a coordinate
/// axis.
void AddCoincidences(const mjModel& m, Numbers& numbers);

}  // namespace mjforge::family
