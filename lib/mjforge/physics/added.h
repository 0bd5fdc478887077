#pragma once

// Bodies that are put into an object's world to see how it takes them.

#include <span>
#include <string>
#include <string_view>

#include <mujoco/mujoco.h>

namespace mjforge::physics {

constexpr double kEarthGravity = 9.81;  // m/s^2, whatever the spec says

/// An MJCF text with more bodies, MJCF too, at the end of its world, and without keyframes, whose
/// numbers would no longer fit.
std::string WithBodies(std::string_view text, std::string_view bodies);

/// A geom of an added body: it says all that a file's defaults could change, and collides with
/// everything that collides. `shape` is its type and size, `mass` in kg.
std::string AddedGeom(std::string_view shape, double mass);

/// Puts what was there before `added` free bodies came, the first of which has number `first`,
/// where `start` has it.
void PlaceOthers(const mjModel& m, mjData& d, std::span<const mjtNum> start, int first, int added);

/// Makes all degrees of freedom except `count` from `first` on so heavy that nothing moves them,
/// and takes limits, springs and actuators away, which could.
void HoldOthers(mjModel& m, int first, int count);

}  // namespace mjforge::physics
