#include "mjforge/physics/overlap.h"

#include <boost/random/sobol.hpp>
#include <cmath>
#include <vector>

#include "mjforge/physics/solids.h"

namespace mjforge::physics {
namespace {

constexpr int kPoints = 2000;

bool Meet(const model::Box3& a, const model::Box3& b) {
  return (a.min.array() < b.max.array()).all() && (b.min.array() < a.max.array()).all();
}

// Points in the box of a solid in its own frame, from a sequence that fills it evenly.
std::vector<Eigen::Vector3d> PointsIn(const model::Part& solid) {
  const model::Box3 box = model::BoundsOf(solid.shape, {});
  boost::random::sobol sequence(3);
  std::vector<Eigen::Vector3d> points(kPoints);
  for (Eigen::Vector3d& p_G : points) {
    for (double& number : p_G) number = std::ldexp(static_cast<double>(sequence()), -64);
    p_G = box.min + p_G.cwiseProduct(box.max - box.min);
  }
  return points;
}

}  // namespace

Overlap FindOverlap(const std::vector<model::Part>& parts) {
  Overlap overlap;
  double most = 0;
  const std::vector<model::Box3> boxes = BoxesOf(parts);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const model::Part& solid = parts[i];
    std::vector<std::size_t> others;
    for (std::size_t j = 0; j < i; ++j) {
      // Pieces of one shape meet at their faces.
      const bool are_one = !solid.piece_of.empty() && solid.piece_of == parts[j].piece_of;
      if (!are_one && Meet(boxes[i], boxes[j])) others.push_back(j);
    }
    if (others.empty() || !(solid.mass > 0)) continue;
    int inside = 0;
    std::vector<int> shared(others.size());
    int twice = 0;
    for (const Eigen::Vector3d& p_G : PointsIn(solid)) {
      if (!model::Contains(solid.shape, {}, p_G)) continue;
      ++inside;
      const Eigen::Vector3d p_B = solid.X_BG.p + solid.X_BG.q * p_G;
      for (std::size_t j = 0; j < others.size(); ++j) {
        const model::Part& other = parts[others[j]];
        if (!model::Contains(other.shape, other.X_BG, p_B)) continue;
        ++twice;
        ++shared[j];
        break;
      }
    }
    if (inside == 0) continue;
    overlap.mass += solid.mass * twice / inside;
    for (std::size_t j = 0; j < others.size(); ++j) {
      const double mass = solid.mass * shared[j] / inside;
      if (mass <= most) continue;
      most = mass;
      overlap.first = others[j];
      overlap.second = i;
    }
  }
  return overlap;
}

}  // namespace mjforge::physics
