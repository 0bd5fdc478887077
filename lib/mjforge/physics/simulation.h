// Memory for simulations: reused mjData and buffers for contacts. Also measures the state of a
// simulation.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "mjforge/compiled/compiled.h"

namespace mjforge::physics {

/// Owner of an mjData, which is reused for models with the same sizes, because its allocation takes
/// as long as 50 steps. Most variants of a spec have the same sizes.
class Workspace {
 public:
  /// Returns data of the model in the initial state, valid until the next call. Throws
  /// std::exception if there is not enough memory.
  mjData& For(const mjModel& m);

 private:
  compiled::Data data_;
  std::vector<std::byte> sizes_;  // sizes in the mjModel for which `data_` was allocated
};

/// Exception: the contacts of a model need a buffer of more than 10,000 contacts or, in MuJoCo 2.2,
/// constraint matrices of more than 1 GB.
struct BuffersTooLarge : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Largest number of steps of a simulation.
inline constexpr double kMostSteps = 1e7;

/// Returns true if MuJoCo ignored contacts or constraints since the last reset, because its buffers
/// were full.
bool IsCrowded(const mjData& d);
/// At least doubles the buffers of the model for contacts and constraint rows; mjData must be
/// allocated again. Throws BuffersTooLarge if the buffers would be too large.
void MakeRoom(mjModel& m);

/// Calls `simulate` with data of the model in the initial state, and again with larger buffers
/// until all contacts and constraints fit. Returns the result of the last call. Throws
/// BuffersTooLarge.
template <typename Simulation>
auto Simulate(mjModel& m, Workspace& workspace, const Simulation& simulate) {
  for (;;) {
    mjData& d = workspace.For(m);
    auto result = simulate(d);
    if (!IsCrowded(d)) return result;
    MakeRoom(m);
  }
}

/// Upper bound of the speed of all points of all geoms, and the body with the fastest point.
struct FastestBody {
  double speed = 0;  // m/s
  int body = 0;
};
/// Returns the fastest body that is not fixed to the world; the world (0) if no body moves. The
/// speed is an upper bound, because each geom is replaced by its bounding sphere. Uses the poses
/// and velocities that MuJoCo last computed in `d` (geom_xpos, subtree_com, cvel).
FastestBody FindFastestBody(const mjModel& m, const mjData& d);

/// Returns the ids of the bodies with free joints.
std::vector<int> FreeBodies(const mjModel& m);

/// Returns the bounding box, in the world frame, of the colliding geoms of the trees of bodies with
/// these roots.
model::Box3 CollidingBox(const mjModel& m, const mjData& d, const std::vector<int>& roots);

/// Numbers in qpos of the position of a joint, in the order of mjtJoint: free, ball, slide, hinge.
inline constexpr std::size_t kPositionSizes[] = {7, 4, 1, 1};

inline std::span<const mjContact> ContactsOf(const mjData& d) {
  return {d.contact, static_cast<std::size_t>(d.ncon)};
}

/// Returns the depth of the deepest contact, m; 0 if nothing penetrates.
double DeepestContact(const mjData& d);

/// Returns true if MuJoCo found numbers that are NaN or too large and reset the data.
bool HasDiverged(const mjData& d);

/// Returns MuJoCo's warnings since the data was reset.
std::vector<std::string> WarningsOf(const mjData& d);

}  // namespace mjforge::physics
