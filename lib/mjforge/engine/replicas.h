#pragma once

#include "mjforge/diag/diag.h"
#include "mjforge/engine/frames.h"
#include "mjforge/engine/xml_tree.h"

namespace mjforge::engine {

/// Writes out each `<replicate>` (MuJoCo 3.1.5) as `<frame>`s with the names, the poses and the
/// order of MuJoCo 4.0: to names are added `sep` and the number, with as many digits as `count`
/// has, those of inner ones first. What refers to what is replicated (actuators, sensors, ...) is,
/// too. `refuse` is told what cannot be. True if the tree is another one now.
bool WriteReplicas(XmlElement& root, const diag::Sources& sources, diag::Findings& findings,
                   const RefuseLater& refuse);

}  // namespace mjforge::engine
