#ifndef MJFORGE_PHYSICS_OVERLAP_H_
#define MJFORGE_PHYSICS_OVERLAP_H_

#include <cstddef>

#include "mjforge/physics/subject.h"

namespace mjforge::physics {

/// Mass that is counted twice because the solids of a body overlap.
struct Overlap {
  double mass = 0;  // kg, of the body
  // The two that share most, as numbers in body.solids.
  std::size_t first = 0;
  std::size_t second = 0;
};

/// By quasi-Monte Carlo: 2,000 points in each solid that meets an earlier one. A
/// point in several solids counts for all but the first of them. The error is
/// below a hundredth of the solid's mass.
Overlap FindOverlap(const RigidBody& body);

}  // namespace mjforge::physics

#endif  // MJFORGE_PHYSICS_OVERLAP_H_
