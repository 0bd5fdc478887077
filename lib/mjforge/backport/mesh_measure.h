// Volume or area of a compiled mesh, and the box with the same inertia.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "mjforge/engine/engine.h"

namespace mjforge::backport {

/// The rule by which a mesh determines mass and inertia: `inertia` of a mesh in MuJoCo 3.2.5 and
/// later.
enum class MeshInertiaKind {
  kLegacy,  // pyramids from the centre of mass to each face, whatever the face's orientation
  kExact,   // the solid that the faces enclose
  kConvex,  // the convex hull
  kShell,   // the faces themselves; densities are masses per area
};

/// Returns the kind for a value of the MJCF attribute `inertia`; nullopt for other words.
std::optional<MeshInertiaKind> KindNamed(std::string_view word);

/// A box with the inertia of a mesh, in the frame of the compiled mesh.
struct MeshMeasure {
  double size = 0;                            // volume, m^3; of a shell the area, m^2
  std::array<mjtNum, 3> box = {};             // half sizes, m; zero if `size` is not positive
  std::array<mjtNum, 3> pos = {};             // centre of mass, m
  std::array<mjtNum, 4> quat = {1, 0, 0, 0};  // principal axes
};

/// Measures a mesh. kLegacy requires a mesh that MuJoCo compiled by this rule, because the frame of
/// such a mesh is at the centre of mass; kConvex requires a mesh with a convex hull.
MeshMeasure Measure(const mjModel& m, int mesh, MeshInertiaKind kind);

}  // namespace mjforge::backport
