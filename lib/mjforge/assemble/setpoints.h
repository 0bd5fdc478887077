// Setpoints of actuators at the start of a whole object.

#pragma once

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Returns true for actuators with an activation state (MuJoCo's `act`).
bool HasActivation(const model::Element& actuator);

/// Completes `object.setpoints`: a position servo holds its joint at the joint's start position,
/// unless the spec gives another setpoint. Reports controls and activations outside of their
/// ranges. Actuators must be in their final order.
void CompleteSetpoints(model::Object& object, diag::Findings& findings);

}  // namespace mjforge::assemble
