// Containment test: balls dropped into an object must stay inside, and leave when the object is
// turned over.
#pragma once

#include <string>
#include <string_view>

#include "mjforge/model/model.h"
#include "mjforge/physics/probe_bodies.h"

namespace mjforge::physics {

/// Returns the MJCF text of an object with the balls of checks.holds added.
std::string WithBalls(std::string_view text, const model::HoldingCheck& holding);

/// Drops the balls into the object, which is held in place, and then turns gravity by 180 degrees
/// if checks.holds demands that the balls leave. Reports balls that the object loses or keeps, and
/// fills in result.holds. `test.m` must be loaded from a text of WithBalls(). May throw
/// std::exception.
void CheckContainment(const ProbeTest& test);

}  // namespace mjforge::physics
