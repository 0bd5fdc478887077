#pragma once

#include "mjforge/picture/scene.h"

namespace mjforge::picture {

// Each draws into a scene what its layer shows in addition to the faded object. `around` is the
// object's shape.
void DrawBounds(const Subject::State& state, const Shapes& around, Scene& scene);
void DrawInertias(const Subject::State& state, const Shapes& around, Scene& scene);
void DrawJoints(const Subject::State& state, const Shapes& around, Scene& scene);

}  // namespace mjforge::picture
