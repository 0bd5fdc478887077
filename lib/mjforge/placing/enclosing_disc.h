// Smallest disc that encloses given discs.

#pragma once

#include <span>

#include "mjforge/placing/footprint.h"

namespace mjforge::placing {

/// Returns the smallest disc that contains all discs, of which there is at least one.
Disc EnclosingDisc(std::span<const Disc> discs);

}  // namespace mjforge::placing
