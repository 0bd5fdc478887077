// The start state of a whole object: setpoints of its actuators, and a check of its equalities.

#pragma once

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Returns true for actuators with an activation state (MuJoCo's `act`).
bool HasActivation(const model::Element& actuator);

/// Completes `object.setpoints`: a position servo of a joint with a start position holds the joint
/// there, unless the spec gives another setpoint. Reports controls and activations outside of their
/// ranges. Actuators must be in their final order.
void CompleteSetpoints(model::Object& object, diag::Findings& findings);

/// Adds a finding for each active equality of joints, and each connect and weld, that the start
/// positions violate by more than 0.1 mm or 0.1 degrees.
void CheckEqualities(const model::Object& object, diag::Findings& findings);

}  // namespace mjforge::assemble
