// Copy of a model whose free bodies are held in place, and which has no floor.
#pragma once

#include "mjforge/engine/engine.h"

namespace mjforge::physics {

/// Returns a copy of the model in which actuators are disabled, planes of the world do not collide,
/// and a large armature keeps each free body in place.
engine::Model HeldModel(const mjModel& model);

}  // namespace mjforge::physics
