// Measures compiled meshes: the volume or area, and the box with the same inertia.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "mjforge/engine/engine.h"

namespace mjforge::backport {

/// Rule by which MuJoCo computes the mass and inertia of a mesh: the value of the attribute
/// `inertia` of meshes in MuJoCo 3.2.5 and later.
enum class MeshInertiaKind {
  kLegacy,  // pyramids from the centre of mass to each face, whatever the face's orientation
  kExact,   // the solid that the faces enclose
  kConvex,  // the convex hull
  kShell,   // the faces themselves; densities are masses per area
};

/// Returns the rule for a value of the MJCF attribute `inertia`; nullopt for other words.
std::optional<MeshInertiaKind> KindNamed(std::string_view word);

/// The box with the same inertia as a mesh, in the frame of the compiled mesh.
struct MeshMeasure {
  double size = 0;                            // volume, m^3; of a shell the area, m^2
  std::array<mjtNum, 3> box = {};             // half sizes, m; zero if `size` is not positive
  std::array<mjtNum, 3> pos = {};             // centre of mass, m
  std::array<mjtNum, 4> quat = {1, 0, 0, 0};  // orientation of the principal axes
};

/// Measures a compiled mesh by the rule `kind`. kLegacy requires a mesh that MuJoCo compiled by
/// this rule, because Measure() takes the origin of the frame as the centre of mass; kConvex
/// requires a mesh with a convex hull.
MeshMeasure Measure(const mjModel& m, int mesh, MeshInertiaKind kind);

}  // namespace mjforge::backport
