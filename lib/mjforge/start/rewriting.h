// Steps of moving the zero configuration, each for one section of the object. All steps read poses
// and lengths from the configurations, which still have the old zero.
#pragma once

#include "mjforge/model/model.h"
#include "mjforge/start/configurations.h"

namespace mjforge::start {

/// Rewrites the equalities that MuJoCo measures from the zero configuration.
void RewriteEqualities(const Configurations& configurations, model::Object& object);

/// Returns true if MuJoCo takes the rest length of the tendon's spring from the zero configuration,
/// and this length is another one at the start.
bool ChangesSpring(const Configurations& configurations, const model::Element& tendon);
/// Writes the rest lengths of such tendons.
void RewriteTendons(const Configurations& configurations, model::Object& object);

/// Rewrites cameras and lights that follow their body: MuJoCo takes their offset from the body, or
/// from the centre of mass, from the zero configuration.
void RewriteViews(const Configurations& configurations, model::Object& object);

}  // namespace mjforge::start
