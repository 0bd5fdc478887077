// Camera directions and joint positions for pictures of a spec, from its key `view:`.
#pragma once

#include "mjforge/picture/picture.h"
#include "mjforge/spec/spec.h"

namespace mjforge::app {

/// Returns the camera view `chosen`; directions that were not chosen come from the spec's `view:`.
picture::View ViewOf(const spec::ObjectSpec& spec, picture::View chosen = {});

/// Moves joints into the pose of the spec's `view:`. Adds a warning for a joint that cannot reach
/// its position. Ignores joints that the variant does not have, because the library `assemble`
/// reports them.
void SetPoseOf(const spec::ObjectSpec& spec, picture::Subject& subject, diag::Findings& findings);

/// Returns false, and adds a finding, if a joint is a hinge or slide whose position has another
/// dimension.
bool IsInUnitOf(const picture::Joint& joint, expr::Dimension dimension, diag::Findings& findings);

}  // namespace mjforge::app
