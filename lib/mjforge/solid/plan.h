#pragma once

// The plan of a prism: its outline and its holes.

#include <optional>
#include <vector>

#include "mjforge/solid/moments.h"

namespace mjforge::solid {

/// The plan in the middle and at the ends of a prism, with the same corners.
struct Levels {
  Area middle;
  Area end;
};

struct Plan {
  /// The outline, rounded with `round`, and holes: what lies to the left of all is the prism.
  std::vector<Outline> loops;
  double round = 0;

  /// The border where all sides are moved inwards by `inset`.
  std::vector<Node> BorderAt(double inset) const;
  /// `per_turn`, `inside`: as for PointsOf.
  Levels LevelsAt(double bevel, int per_turn, bool inside) const;

 private:
  std::vector<Corner> CornersOf(std::size_t loop, double inset) const;
};

/// Nothing, and a fault, for a prism that cannot be.
std::optional<Plan> PlanOf(const Prism& prism, Fault& fault);

}  // namespace mjforge::solid
