// Render meshes of lathes and prisms, and functions for all render meshes: number of segments,
// texture projection, rounding of coordinates.

#pragma once

#include <numbers>

#include "mjforge/solid/convex_partition.h"
#include "mjforge/solid/inset_polygon.h"

namespace mjforge::solid {

inline constexpr double kWholeTurn = 2 * std::numbers::pi;

/// Returns the maximum chord error (sagitta), m, of the render mesh of a shape with this half size,
/// m: `share` times the half size, but at most 0.25 mm.
double ChordError(double half_size, double share = 0.005);

/// Returns the number of segments in a whole turn for this chord error: 16, 32, 64 and so on, so
/// that most variants of a spec have the same number. At most 48 segments are within `angle`, rad,
/// the visible part of the turn.
int SegmentsPerTurn(double radius, double chord_error, double angle);

/// Adds two triangles between four corners, counter-clockwise.
void AddQuad(int a, int b, int c, int d, TriangleMesh& mesh);

/// Adds the triangles of a face, whose indices are relative to the vertex `first`.
void AddFace(const std::vector<std::array<int, 3>>& triangles, int first, bool is_reversed,
             TriangleMesh& mesh);

/// Makes the render mesh of a lathe. `outline` is its profile, closed at the axis, or, if the lathe
/// has a wall, the outline of the wall. Outline::sources has, for each point of the outline, the
/// index of the point of `lathe.profile` from which it was made.
TriangleMesh MakeLatheMesh(const Lathe& lathe, const Outline& outline,
                           const ConvexPartition& partition);

/// Makes the render mesh of a prism with these cross sections.
TriangleMesh MakeExtrusionMesh(const Prism& prism, const PrismSections& sections);

/// Returns the position of a point in a picture that is projected from above, m: the first
/// coordinate is to the right in the picture, the second is down.
inline Point2 OnPicture(const TextureMapping& texture, const Point2& p) {
  return texture.is_turned ? Point2(p.y(), p.x()) : Point2(p.x(), -p.y());
}

/// Adds texture coordinates by projection along z, as MuJoCo maps a texture to a box: u is along x
/// and v is along -y (along y and x if `texture.is_turned`). Adds none if the unit is kNone.
void ProjectTextureFromAbove(const TextureMapping& texture, TriangleMesh& mesh);

/// Rounds positions to a micrometre (in shapes below 2 mm or above 10 m to about a millionth of the
/// size), normals to 1e-4, and texture coordinates to 1e-5. The error is invisible, and the MJCF
/// file gets shorter.
void RoundCoordinates(TriangleMesh& mesh);

}  // namespace mjforge::solid
