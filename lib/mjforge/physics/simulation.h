// Reused simulation data, sizes of the buffers for contacts, and measures of a simulation's state.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "mjforge/compiled/compiled.h"

namespace mjforge::physics {

/// MuJoCo's mjData, reused for models with the same sizes, because the allocation of the data takes
/// as long as 50 steps. Most variants of a spec have the same sizes.
class Workspace {
 public:
  /// Returns data for the model at its initial state, valid until the next call. Throws
  /// std::exception if there is not enough memory.
  mjData& For(const mjModel& m);

 private:
  compiled::Data data_;
  std::vector<std::byte> sizes_;  // sizes in the mjModel for which `data_` was allocated
};

/// Exception: the contacts of a model need a buffer for more than 10,000 contacts or, in releases
/// of MuJoCo with fixed buffers, constraint matrices of more than 1 GB.
struct NoRoom : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Largest number of steps of a simulation.
inline constexpr double kMostSteps = 1e7;

/// Returns true if MuJoCo ignored contacts or constraints since the last reset, because its buffers
/// were full.
bool IsCrowded(const mjData& d);
/// Doubles the model's buffers for contacts and constraint rows; mjData must be allocated again.
/// Throws NoRoom if the buffers would be too large.
void MakeRoom(mjModel& m);

/// Calls `simulate` with data at the initial state, and again with larger buffers until all
/// contacts fit. Returns the result of the last call. Throws NoRoom.
template <typename Simulation>
auto Simulate(mjModel& m, Workspace& workspace, const Simulation& simulate) {
  for (;;) {
    mjData& d = workspace.For(m);
    auto result = simulate(d);
    if (!IsCrowded(d)) return result;
    MakeRoom(m);
  }
}

/// Upper bound of the speed of any point, and the body with that point.
struct FastestBody {
  double speed = 0;  // m/s
  int body = 0;
};
/// Returns the fastest body, without bodies fixed to the world. Assumes that each geom has a point
/// at its bounding radius from its centre.
FastestBody FindFastestBody(const mjModel& m, const mjData& d);

/// Returns the ids of the bodies with free joints.
std::vector<int> FreeBodies(const mjModel& m);

/// Returns the bounding box of the colliding geoms of the trees with these roots, in the world
/// frame.
model::Box3 CollidingBox(const mjModel& m, const mjData& d, const std::vector<int>& roots);

/// Returns the depth of the deepest contact, m.
double DeepestContact(const mjData& d);

/// Returns true if MuJoCo found numbers that are NaN or too large and reset the data.
bool HasDiverged(const mjData& d);

/// Returns MuJoCo's warnings since the data was reset.
std::vector<std::string> WarningsOf(const mjData& d);

}  // namespace mjforge::physics
