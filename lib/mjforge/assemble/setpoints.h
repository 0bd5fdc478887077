// Setpoints (ctrl and act) of actuators at the start of an object.

#pragma once

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Returns true if the actuator has an activation state (MuJoCo's `act`).
bool HasActivation(const model::Element& actuator);

/// Completes `object.setpoints`: a position servo holds its joint at the joint's start position,
/// unless the spec specifies another setpoint. Leaves no setpoints if all are 0. Reports controls
/// and activations outside their ranges. The actuators must already be in their final order.
void CompleteSetpoints(model::Object& object, diag::Findings& findings);

}  // namespace mjforge::assemble
