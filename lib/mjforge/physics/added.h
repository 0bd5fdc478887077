#pragma once

// Bodies that are put into an object's world to see how it takes them.

#include <span>
#include <string>
#include <string_view>

#include <mujoco/mujoco.h>

namespace mjforge::physics {

constexpr std::string_view kAddedPrefix = "mjforge-";  // of their names
constexpr double kEarthGravity = 9.81;                 // m/s^2, whatever the spec says

/// An MJCF text with more bodies, MJCF too, at the end of its world, and more equalities; without
/// keyframes, whose numbers would no longer fit.
std::string WithBodies(std::string_view text, std::string_view bodies,
                       std::string_view equalities = {});

constexpr std::string_view kUsualContact = R"(condim="3" friction="1 0.005 0.0001")";

/// A geom of an added body: it says all that a file's defaults could change, and collides with
/// everything that collides. `shape` is its type and size, `mass` in kg; `contact` its condim and
/// friction.
std::string AddedGeom(std::string_view shape, double mass,
                      std::string_view contact = kUsualContact);

/// Puts what was there before bodies came, whose first joint is `first`, with `added` positions
/// together, where `start` has it.
void PlaceOthers(const mjModel& m, mjData& d, std::span<const mjtNum> start, int first, int added);

/// Makes a degree of freedom so heavy that nothing moves it.
void HoldDof(mjModel& m, int dof);

/// Makes all degrees of freedom except `count` from `first` on so heavy that nothing moves them,
/// and takes limits, springs and actuators away, which could.
void HoldOthers(mjModel& m, int first, int count);

}  // namespace mjforge::physics
