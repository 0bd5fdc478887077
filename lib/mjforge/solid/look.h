#pragma once

#include "mjforge/solid/convex.h"

namespace mjforge::solid {

/// What is seen of a turned outline: 48 segments a turn. `along`: the texture coordinate of each of
/// the input's points, and behind the last that of the first again where the outline is closed.
struct TurnedLook {
  const Outline& outline;
  const Partition& partition;
  const std::vector<double>& along;
  double angle = 0;
  double crease = 0;
  double around = 1;  // texture coordinate at the end of a whole turn
};
Surface Make(const TurnedLook& look);

/// Positions rounded to a millionth of the size, normals to a ten-thousandth: nobody sees more, and
/// each digit is text.
void RoundForText(Surface& surface);

}  // namespace mjforge::solid
