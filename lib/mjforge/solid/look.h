#pragma once

#include "mjforge/solid/convex.h"
#include "mjforge/solid/plan.h"

namespace mjforge::solid {

/// What is seen of a turned outline: 48 segments a turn. Texture coordinates go along `line`, the
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

/// Positions rounded to a millionth of the size, normals to a ten-thousandth: nobody sees more, and
/// each digit is text.
void RoundForText(Surface& surface);

}  // namespace mjforge::solid
