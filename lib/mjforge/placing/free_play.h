// Positions of a footprint in a region: tests if it fits, and maps drawn numbers to positions.

#pragma once

#include <optional>

#include <Eigen/Dense>

#include "mjforge/placing/footprint.h"

namespace mjforge::placing {

/// Maps two random numbers `uv` to a translation of the footprint in the region's frame. Each
/// number is from -1 to 1; in a round region, `uv` is a point of the unit disc. The result can be
/// any translation that keeps the footprint in the region, at least the region's margin away from
/// its border (Minkowski erosion of the region by the footprint). `overhang` is the share of the
/// footprint's area that may be outside; if it is positive, the result can be any translation with
/// at most this share outside. Returns nullopt if there is no such translation.
std::optional<Eigen::Vector2d> PositionIn(const model::Region& region, const Footprint& footprint,
                                          const Eigen::Vector2d& uv, double overhang);

/// Returns true if the translated footprint is in the region, at least the region's margin away
/// from its border, except for the share `overhang` of its area.
bool FitsAt(const model::Region& region, const Footprint& footprint,
            const Eigen::Vector2d& translation, double overhang);

}  // namespace mjforge::placing
