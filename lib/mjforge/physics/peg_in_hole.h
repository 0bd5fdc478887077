// Peg-in-hole test: pegs, or bodies of the object, must fit into the object's holes.
#pragma once

#include <string>
#include <string_view>

#include "mjforge/model/model.h"
#include "mjforge/physics/probe_bodies.h"

namespace mjforge::physics {

/// Returns an MJCF text with the pegs of checks.fits.
std::string WithPegs(std::string_view text, const model::Checks& checks);

/// Drops each peg or body along the z axis of its hole's site, with everything else held in place.
/// Reports those that do not get as deep as they should, or that could leave sideways there, and
/// fills in result.fits. The model is made from a text of WithPegs(). May throw std::exception.
void CheckPegInHole(const ProbeTest& test);

}  // namespace mjforge::physics
