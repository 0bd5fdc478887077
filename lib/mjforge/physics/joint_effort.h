// Efforts that joints need: those that actuators have, and those that a person has.
#pragma once

#include "mjforge/physics/simulation.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Warns of actuators of hinges and slides that have no gear, that are too weak to hold their joint
/// somewhere in its range against weight, springs and friction, or whose control range leads a
/// position servo far beyond the joint's range; and of joints whose damping, dry friction or
/// armature neither a person nor their actuators overcome. Findings about actuators and joints
/// without a place point at `mark`. May throw std::exception.
void CheckEfforts(const mjModel& m, Workspace& workspace, const model::Object& object,
                  diag::SourceMark mark, static_checks::Reporter& reporter);

}  // namespace mjforge::physics
