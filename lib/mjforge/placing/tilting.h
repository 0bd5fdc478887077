// Heights of a body's centre of mass above the ground, and whether tilting lowers it.

#pragma once

#include <Eigen/Dense>

#include "mjforge/placing/obstacles.h"

namespace mjforge::placing {

/// Returns the height of a body's centre of mass above the ground, m, if the body touches the
/// ground and the direction `down`, of length 1, points down. Shapes, centre of mass and direction
/// are in one frame.
double CenterHeight(const PlacedShapes& shapes, const Eigen::Vector3d& center,
                    const Eigen::Vector3d& down);

/// Returns the direction near `down` at which the centre of mass is lowest, or a direction on the
/// floor of a valley of heights, because the search takes only steps that lower the centre of mass
/// by more than rounding errors. The search ends at the angle `most`, rad, from `down`.
Eigen::Vector3d LowestNear(const PlacedShapes& shapes, const Eigen::Vector3d& center,
                           const Eigen::Vector3d& down, double most);

/// Returns true if the centre of mass sinks when the body is tilted by `angle`, rad, in any
/// direction: the body then does not rest with `down` pointing down. Round shapes are exact.
bool SinksWhenTilted(const PlacedShapes& shapes, const Eigen::Vector3d& center,
                     const Eigen::Vector3d& down, double angle);

}  // namespace mjforge::placing
