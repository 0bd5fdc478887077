// Largest free disc in a region between the bodies that were placed there already.

#pragma once

#include "mjforge/model/model.h"
#include "mjforge/placing/obstacles.h"

namespace mjforge::placing {

/// Returns the diameter, m, of the largest disc in the region, at least the region's margin away
/// from its border, on which an upright cylinder of the height `height`, m, is free of other
/// bodies; 0 if there is no such disc. The error is at most 1 mm, unless the search ends early,
/// after 1000 steps. X_WR is the pose of the region. The body that has the region is no obstacle.
double WidestGap(const model::Region& region, const model::Pose& X_WR, double height,
                 const Obstacles& obstacles, const Support& support);

}  // namespace mjforge::placing
