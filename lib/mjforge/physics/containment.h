// Containment test: balls dropped into an object must stay inside, and leave when it is turned
// over.
#pragma once

#include <string>
#include <string_view>

#include "mjforge/model/model.h"
#include "mjforge/physics/probe_bodies.h"

namespace mjforge::physics {

/// Returns an MJCF text with the balls of checks.holds.
std::string WithBalls(std::string_view text, const model::HoldingCheck& holding);

/// Drops the balls into the object, which is held in place, and then turns gravity around. Reports
/// balls that the object loses or keeps, and fills in result.holds. The model is made from a text
/// of WithBalls(). May throw std::exception.
void CheckContainment(const ProbeTest& test);

}  // namespace mjforge::physics
