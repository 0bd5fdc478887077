// The view of a spec in pictures.
#pragma once

#include "mjforge/picture/picture.h"
#include "mjforge/spec/spec.h"

namespace mjforge::app {

/// Returns the camera view `chosen`, with the spec's `view:` for directions that were not chosen.
picture::View ViewOf(const spec::ObjectSpec& spec, picture::View chosen = {});

/// Moves joints into the pose of the spec's `view:`. Adds a warning for a joint that does not reach
/// its position. Ignores joints that the variant does not have, which `assemble` reports.
void SetPoseOf(const spec::ObjectSpec& spec, picture::Subject& subject, diag::Findings& findings);

}  // namespace mjforge::app
