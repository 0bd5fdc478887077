// Copy of a model whose free bodies are held in place, and which has no floor.
#pragma once

#include "mjforge/engine/engine.h"

namespace mjforge::physics {

/// Returns a copy without actuators, without level planes of the world, and with an armature for
/// each free joint that keeps its body in place.
engine::Model HeldModel(const mjModel& model);

}  // namespace mjforge::physics
