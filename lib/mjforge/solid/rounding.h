#pragma once

#include <optional>
#include <vector>

#include "mjforge/solid/outline.h"

namespace mjforge::solid {

/// A corner of an outline; with a radius the arc that takes its place, which begins at the angle
/// `from` and goes on by `sweep`, to the left if that is positive.
struct Corner {
  Point place;  // of a corner that stays; otherwise the centre of its arc
  double radius = 0;
  double from = 0;
  double sweep = 0;
};

/// The corners of an outline that are rounded with a radius each, 0: not at all, and moved to its
/// left by `inset`: arcs of corners to the left shrink by it, others grow. Nothing, and a fault,
/// where a side is too short.
std::optional<std::vector<Corner>> RoundedCorners(const Outline& outline,
                                                  const std::vector<double>& radii, double inset,
                                                  Fault& fault);

/// The corners, and points along arcs: at least one a step, `per_turn` steps a whole turn. The
/// points of arcs to the left are on them. `inside`: those of arcs to the right are so far out that
/// the lines between them touch the arc, so that what is on the left gets no larger.
std::vector<Point> PointsOf(const std::vector<Corner>& corners, int per_turn, bool inside);

}  // namespace mjforge::solid
