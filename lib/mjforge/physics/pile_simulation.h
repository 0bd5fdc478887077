// Simulation of a pile: releases its bodies one after the other and brings them to rest.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <mujoco/mujoco.h>
#include <Eigen/Dense>

#include "mjforge/model/model.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {

/// A body of a pile in the compiled model.
struct PiledBody {
  int id = 0;
  double radius = 0;                                // m, bounding sphere around the centre of mass
  Eigen::Vector3d p_BCm = Eigen::Vector3d::Zero();  // m, centre of mass of its tree
  const model::Pile::Item* release = nullptr;       // pile item with the pose of its release
};

/// Releases the bodies of one pile, while all other bodies are held.
class PileSimulation {
 public:
  /// `bodies` are in the order of their release. `X_WR` is the pose of the region in the world.
  PileSimulation(mjModel& m, mjData& d, const model::Pile& pile,
                 const std::vector<PiledBody>& bodies, const model::Pose& X_WR)
      : m_(m), d_(d), pile_(pile), X_WR_(X_WR), bodies_(bodies) {}

  /// Simulates the pile; returns true if the bodies came to rest. Restores the options and the
  /// damping of the model.
  bool Run();

 private:
  bool CanGoOn() const;
  bool IsIn(int body, const PiledBody& piled) const;
  bool IsReleased(int body) const;
  void Hold();
  void Park();
  void MoveTo(const PiledBody& body, const Eigen::Vector2d& p_R, double height);
  void ReleaseAll();
  void Release(const PiledBody& body);
  bool Touches(const PiledBody& body);
  void Step();
  void SlowDown(double end);
  bool StaysAtRest(double end);
  std::vector<model::Pose> Poses() const;
  bool AreAt(const std::vector<model::Pose>& before, double share) const;

  mjModel& m_;
  mjData& d_;
  const model::Pile& pile_;
  model::Pose X_WR_;
  const std::vector<PiledBody>& bodies_;
  std::size_t released_ = 0;  // number of bodies that are released
  double parked_ = 0;         // m, height above which bodies wait
  std::vector<mjtNum> held_;  // qpos, nq; bodies that are not released stay there
  std::optional<Stepper> stepper_;
};

}  // namespace mjforge::physics
