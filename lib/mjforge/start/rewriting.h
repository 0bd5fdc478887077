// Steps of moving an object's zero configuration to its start, each for one kind of elements. All
// steps read poses and lengths from `configurations`, which keep the old zero.
#pragma once

#include "mjforge/model/model.h"
#include "mjforge/start/configurations.h"

namespace mjforge::start {

/// Rewrites the equalities that MuJoCo measures from the zero configuration.
void RewriteEqualities(const Configurations& configurations, model::Object& object);

/// Returns true if MuJoCo takes the rest length of the tendon's spring from the zero configuration,
/// and that length changes when zero moves to the start.
bool ChangesSpring(const Configurations& configurations, const model::Element& tendon);
/// Writes `springlength` of all tendons for which ChangesSpring() returns true.
void RewriteTendons(const Configurations& configurations, model::Object& object);

/// Rewrites cameras and lights with the mode track or trackcom, because MuJoCo computes their
/// offset from the body or its centre of mass in the zero configuration.
void RewriteViews(const Configurations& configurations, model::Object& object);

}  // namespace mjforge::start
