// Check of the forces that joints need, against the forces of actuators and of a person.
#pragma once

#include "mjforge/physics/simulation.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Warns of actuators of hinges and slides that have a gear of 0, that are too weak to hold their
/// joint somewhere in its range against weight, springs and friction, or whose control range leads
/// a position servo far beyond the joint's range. Warns of joints whose damping, dry friction or
/// armature neither a person nor their actuators overcome. Findings about actuators and joints
/// without a place point at `mark`. May throw std::exception.
void CheckEfforts(const mjModel& m, Workspace& workspace, const model::Object& object,
                  diag::SourceMark mark, static_checks::Reporter& reporter);

}  // namespace mjforge::physics
