// Explicit lists of geom pairs for MuJoCo's collision detection.
#pragma once

#include <vector>

#include <mujoco/mujoco.h>

namespace mjforge::engine {

namespace internal {
template <class Model>
constexpr bool TakesPairs() {
  return requires(Model & m) { m.opt.collision; }
  &&!requires(Model & m) { m.pair_solreffriction; };
}
}  // namespace internal

/// True if this release can restrict collision detection to a list of geom pairs
/// (mjOption::collision, up to 2.3.5). Such a release may test all geoms of two nearby bodies
/// against each other; later releases have bounding volume hierarchies instead.
inline constexpr bool kTakesPairs = internal::TakesPairs<mjModel>();

/// A list of geom pairs, each with the contact parameters that MuJoCo would mix for the pair.
class GeomPairs {
 public:
  void Clear();
  /// Adds a pair of geoms, neither of which may be a height field. Contacts equal those that MuJoCo
  /// finds without the list if pairs are added in MuJoCo's order: by the lower of the two body ids,
  /// then by the higher body id, then by geom ids.
  void Add(const mjModel& m, int geom1, int geom2);

  /// Calls mj_step (or mj_collision) with only the pairs of this list; if kTakesPairs is false,
  /// MuJoCo finds all pairs itself.
  void Step(mjModel& m, mjData& d);
  void Collide(mjModel& m, mjData& d);

 private:
  template <class Model, bool kTaken>
  class ScopedPairs;

  std::vector<int> geom1_;
  std::vector<int> geom2_;
  std::vector<int> dim_;
  std::vector<int> signature_;
  std::vector<mjtNum> margin_;
  std::vector<mjtNum> gap_;
  std::vector<mjtNum> friction_;  // 5 per pair
  std::vector<mjtNum> solref_;    // mjNREF per pair
  std::vector<mjtNum> solimp_;    // mjNIMP per pair
};

}  // namespace mjforge::engine
