#pragma once

#include <array>
#include <numbers>

#include "mjforge/solid/convex.h"
#include "mjforge/solid/plan.h"

namespace mjforge::solid {

inline constexpr double kWholeTurn = 2 * std::numbers::pi;

/// How far a chord of what is seen may lie within the true circle, m, in a shape of that half size.
/// `share`: of the half size.
double ChordError(double half_size, double share = 0.005);

/// Segments of a whole turn with no larger chord error: 16, 32, 64 and so on, since variants with
/// the same number share a mould, but at most 48 in the angle, rad, that is seen of it.
int SegmentsOf(double radius, double chord_error, double angle);

/// The triangles between four corners, counter-clockwise.
void AddQuad(int a, int b, int c, int d, Surface& surface);

/// What is seen of a turned outline. Texture coordinates go along `line`, the
/// points that the outline's sources count, if it is closed back to the first.
struct TurnedLook {
  const Outline& outline;
  const Partition& partition;
  const std::vector<Point>& line;
  bool is_closed = true;
  double angle = 0;
  double crease = 0;
  Texture texture = {};
};
Surface Make(const TurnedLook& look);

/// What is seen of a prism with these plans.
struct PrismLook {
  Levels levels;
  double height = 0;
  double bevel = 0;
  double crease = 0;
  Texture texture;
};
Surface Make(const PrismLook& look);

/// Gives all vertices the texture coordinates that MuJoCo gives a box: along x and against y, in
/// each cross section the same.
void LayFromAbove(const Texture& texture, Surface& surface);

/// Positions rounded to a micrometre (of shapes below 2 mm or above 10 m to a millionth of the
/// size), normals to a ten-thousandth: nobody sees more, and each digit is text.
void RoundForText(Surface& surface);

}  // namespace mjforge::solid
