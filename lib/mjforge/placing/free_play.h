// Positions of a footprint in a region: tests if it fits, and maps drawn numbers to positions.

#pragma once

#include <optional>

#include <Eigen/Dense>

#include "mjforge/placing/footprint.h"

namespace mjforge::placing {

/// Share of a footprint's area that may be outside of a region. If the share is positive, the
/// body's centre of mass must be above the region, 1 mm from its border, so that the body does not
/// tip over.
struct Overhang {
  double share = 0;                                // 0 to 1
  Eigen::Vector2d p_Cm = Eigen::Vector2d::Zero();  // centre of mass in the footprint's frame, m
};

/// Maps two random numbers `uv` to a translation of the footprint in the region's frame. Each
/// number is from -1 to 1; in a round region, `uv` is a point of the unit disc. The result can be
/// any translation that keeps the footprint in the region, at least the region's margin away from
/// its border (Minkowski erosion of the region by the footprint), or that `overhang` allows. With
/// an overhang, `uv` is a share of the way from the middle of the region to the farthest
/// translation in the direction of `uv`. Returns nullopt if there is no such translation.
std::optional<Eigen::Vector2d> PositionIn(const model::Region& region, const Footprint& footprint,
                                          const Eigen::Vector2d& uv, const Overhang& overhang);

/// Returns true if the translated footprint is in the region, at least the region's margin away
/// from its border, or if `overhang` allows the translation.
bool FitsAt(const model::Region& region, const Footprint& footprint,
            const Eigen::Vector2d& translation, const Overhang& overhang);

}  // namespace mjforge::placing
