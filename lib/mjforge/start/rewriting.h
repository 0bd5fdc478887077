// Steps of MoveZeroToStart(), each for one kind of elements. `configurations` contains the poses at
// the zero configuration before the move.
#pragma once

#include "mjforge/model/model.h"
#include "mjforge/start/configurations.h"

namespace mjforge::start {

/// Rewrites the equalities that MuJoCo measures from the zero configuration.
void RewriteEqualities(const Configurations& configurations, model::Object& object);

/// Returns true if MuJoCo computes the rest length of the tendon's spring (no `springlength` is
/// given), and that length changes when the zero configuration moves to the start.
bool ChangesSpring(const Configurations& configurations, const model::Element& tendon);
/// Writes `springlength` of all tendons for which ChangesSpring() returns true.
void RewriteTendons(const Configurations& configurations, model::Object& object);

/// Rewrites cameras and lights with the mode `track` or `trackcom`. MuJoCo computes their offset
/// from the body, or from the centre of mass of its subtree, in the zero configuration.
void RewriteViews(const Configurations& configurations, model::Object& object);

}  // namespace mjforge::start
