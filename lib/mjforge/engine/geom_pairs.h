#pragma once

// The pairs of geoms between which MuJoCo looks for contacts.

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

/// Whether this release can be told all pairs. Up to 2.3 it compares each geom of a body with each
/// of another one that is near; later ones have trees of boxes for that.
inline constexpr bool kTakesPairs = internal::TakesPairs<mjModel>();

/// A list of pairs, each with the contact parameters that MuJoCo would mix for it.
class GeomPairs {
 public:
  void Clear();
  /// Neither is a height field. In MuJoCo's order, contacts are as without the list: by the lower
  /// body, then the higher one, then the geoms.
  void Add(const mjModel& m, int geom1, int geom2);

  /// mj_step and mj_collision, with these pairs alone; without them if the release takes none.
  void Step(mjModel& m, mjData& d);
  void Collide(mjModel& m, mjData& d);

 private:
  template <class Model, bool kTaken>
  class Put;

  std::vector<int> geom1_;
  std::vector<int> geom2_;
  std::vector<int> dim_;
  std::vector<int> signature_;
  std::vector<mjtNum> margin_;
  std::vector<mjtNum> gap_;
  std::vector<mjtNum> friction_;  // 5 of each
  std::vector<mjtNum> solref_;    // mjNREF of each
  std::vector<mjtNum> solimp_;    // mjNIMP of each
};

}  // namespace mjforge::engine
