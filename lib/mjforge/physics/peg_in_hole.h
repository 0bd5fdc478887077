// Peg-in-hole test: pegs, or bodies of the object, must fit into the object's holes.
#pragma once

#include <string>
#include <string_view>

#include "mjforge/model/model.h"
#include "mjforge/physics/probe_bodies.h"

namespace mjforge::physics {

/// Returns the MJCF text of an object with the pegs of checks.fits added.
std::string WithPegs(std::string_view text, const model::Checks& checks);

/// Drops each peg or body along the z axis of its hole's site, with everything else held in place.
/// Reports pegs and bodies that do not reach the required depth, or that could leave sideways at
/// that depth, and fills in result.fits. `test.m` must be loaded from a text of WithPegs(). May
/// throw std::exception.
void CheckPegInHole(const ProbeTest& test);

}  // namespace mjforge::physics
