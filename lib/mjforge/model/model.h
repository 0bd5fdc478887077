// Public header of the library `model`: objects as numbers, and their geometry (bodies, parts,
// masses, bounds, poses, regions); interfaces to the reader of attached MJCF files and to the
// placement of bodies in regions.

#pragma once

#include "mjforge/model/attachment.h"
#include "mjforge/model/forward_kinematics.h"
#include "mjforge/model/mass_and_bounds.h"
#include "mjforge/model/object.h"
#include "mjforge/model/placement.h"
#include "mjforge/model/swept_bounds.h"
