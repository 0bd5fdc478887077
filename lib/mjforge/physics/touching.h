#pragma once

#include <vector>

#include "mjforge/physics/solids.h"

namespace mjforge::physics {

/// Whether two solids of a body are at most `gap` (m) apart, to about a thousandth of their size.
/// Meshes count as their convex hulls.
bool Touch(const model::Part& a, const model::Part& b, double gap);

/// Groups of parts that hold together, as numbers in `parts`; the heaviest group first.
std::vector<std::vector<std::size_t>> Pieces(const std::vector<model::Part>& parts, double gap);

/// The part outside a group that is nearest to it, as a number in `parts`.
struct Neighbour {
  std::size_t part = 0;
  double distance = 0;  // m, above `gap`; to a thousandth of itself or of the parts' size
};
Neighbour NearestOf(const std::vector<model::Part>& parts, const std::vector<std::size_t>& group,
                    double gap);

/// Is a point in the convex hull of the parts, or nearer to it than a thousandth of their size?
bool IsInsideHull(const std::vector<model::Part>& parts, const Eigen::Vector3d& p_B);

}  // namespace mjforge::physics
