// Marks (boxes, axes, labels) that some layers of a picture draw in addition to the object, which
// these layers show translucent.

#pragma once

#include "mjforge/picture/scene.h"

namespace mjforge::picture {

// Functions that add the marks of a layer to a scene: the bounding box, boxes of equal inertia, the
// axes and ranges of joints, or the regions. `around` are the object's shapes, which determine the
// size of the marks.
void DrawBounds(const Subject::State& state, const PlacedShapes& around, Scene& scene);
void DrawInertias(const Subject::State& state, const PlacedShapes& around, Scene& scene);
void DrawJoints(const Subject::State& state, const PlacedShapes& around, Scene& scene);
void DrawRegions(const Subject::State& state, const PlacedShapes& around, Scene& scene);

}  // namespace mjforge::picture
