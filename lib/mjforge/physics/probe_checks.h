// Checks of an object by probe bodies: balls in a container, pegs in holes, and grasps of a
// gripper.
#pragma once

#include <string>
#include <string_view>

#include "mjforge/physics/probe_bodies.h"

namespace mjforge::physics {

/// Returns the MJCF text of an object with the balls of checks.holds added.
std::string WithBalls(std::string_view text, const model::HoldingCheck& holding);

/// Drops the balls into the object, which is held in place, and then turns gravity by 180 degrees
/// if checks.holds demands that the balls leave. Reports balls that the object loses or keeps, and
/// fills in result.holds. `test.m` must be loaded from a text of WithBalls(). May throw
/// std::exception.
void CheckContainment(const ProbeTest& test);

/// Returns the MJCF text of an object with the pegs of checks.fits added.
std::string WithPegs(std::string_view text, const model::Checks& checks);

/// Drops each peg or body along the z axis of its hole's site, with everything else held in place.
/// Reports pegs and bodies that do not reach the required depth, or that could leave sideways at
/// that depth, and fills in result.fits. `test.m` must be loaded from a text of WithPegs(). May
/// throw std::exception.
void CheckPegInHole(const ProbeTest& test);

/// Tries grasps at the sites that checks.grasps names. If checks.grasps names none, tries the sites
/// whose names begin with "grasp"; if there are none, opposite faces of the first free body.
/// Reports sites at which no grasp holds the object, and fills in result.grasps. `test.m` must be
/// loaded from a text of WithGripper(). May throw std::exception.
void CheckGrasps(const ProbeTest& test);

}  // namespace mjforge::physics
