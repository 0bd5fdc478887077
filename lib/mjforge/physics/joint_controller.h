// Controller that drives joints along paths by forces, and measures reach, errors and penetrations.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/physics/joint_couplings.h"
#include "mjforge/physics/joint_drive.h"
#include "mjforge/physics/joint_paths.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {

/// Way in which joints move that equalities and tendons couple to a driven joint.
enum class CoupledJoints {
  kDriven,   // by the controller, too, if an equality of joints determines the motion
  kPassive,  // only by the equality or tendon
};

/// Drives joints of a model whose free bodies are held in place (HeldModel). `m` and its data `d`
/// must outlive this object.
class JointController {
 public:
  JointController(mjModel& m, mjData& d, CoupledJoints coupled);

  const JointCouplings& couplings() const { return couplings_; }

  /// Sets the start positions (qpos, nq numbers), from which joints are driven.
  void Begin(std::span<const mjtNum> start);

  /// Returns the pairs of bodies of one tree that penetrate each other at the start positions.
  std::vector<InitialPenetration> InitialPenetrations() const;

  /// Records the following drives, unless `recorder` is null.
  void RecordTo(FilmRecorder* recorder) { stepper_.RecordTo(recorder); }

  /// Drives several joints at the same time: each along its first path, and then ball joints along
  /// their second and third paths. Each drive begins at the start positions. Returns one result for
  /// each joint, in the order of `joints`.
  std::vector<DrivenJoint> Run(std::span<const int> joints);

 private:
  using Bodies = std::pair<int, int>;  // the lower id first

  /// State of a joint that is being driven along a path.
  struct JointDrive {
    JointPath path;
    DrivenJoint* driven = nullptr;
    std::vector<bool> moved;  // nbody, true for each body that the joint moves
    double home = 0;          // position at which the joint must be at the end of the drive
    double from = 0;          // start and end of the present move, with the push beyond the range
    double to = 0;
    double nearest = 0;  // least distance from the end of the move so far
    double held = 0;     // s, time since the joint last came nearer to the end of the move
    bool counts = true;  // true if `lowest` and `highest` include present positions
    double lowest = 0;
    double highest = 0;

    double End() const { return std::clamp(to, path.low, path.high); }
  };

  void Reset();
  /// Returns the present penetration depth, m, of each pair of bodies that penetrate each other.
  std::map<Bodies, double> DepthsNow() const;
  /// Returns true if both bodies belong to the same tree of bodies. During a drive, other trees and
  /// the world do not move.
  bool AreOneTree(const Bodies& bodies) const;
  /// Stores the penetration `depth` of two bodies of different trees in `driven` if it is the
  /// deepest so far.
  void NoteFreeBody(const Bodies& bodies, double depth, DrivenJoint& driven) const;
  void DriveAll(std::vector<JointDrive>& drives);
  void Start(JointDrive& drive);
  void Finish(const JointDrive& drive);
  /// Moves each joint on its path from `from` to `to`.
  void Move(std::vector<JointDrive>& drives);
  double AddedInertiaOf(int dof);
  /// Applies the forces of one step of a move. `progress.position` is the share of the move, from 0
  /// to 1, that should be complete; `progress.speed` and `progress.acceleration` are the
  /// derivatives of this share with respect to time.
  void SetForces(const std::vector<JointDrive>& drives, const Setpoint& progress);
  void ApplyForces();
  static Setpoint Target(const JointDrive& drive, const Setpoint& progress);
  std::optional<Setpoint> SetpointOfOther(const std::vector<JointDrive>& drives, int joint,
                                          const Setpoint& progress) const;
  void Correct(int joint, int axis, const std::array<double, 3>& errors, double most,
               const Setpoint& setpoint);
  std::array<double, 3> Errors(int joint, int axis, double target) const;
  std::array<double, 3> ErrorsOfHeld(int joint, double target) const;
  double Value(const JointPath& path) const;
  void Measure(std::vector<JointDrive>& drives);
  void MeasureEqualities(DrivenJoint& driven) const;

  mjModel& m_;
  mjData& d_;
  CoupledJoints coupled_;
  JointCouplings couplings_;
  std::vector<mjtNum> start_;                // nq
  std::map<Bodies, double> initial_depths_;  // m, at the start positions
  std::vector<double> added_inertia_;        // nv, inertia added by equalities and tendons
  std::vector<mjtNum> accelerations_;        // nv, desired accelerations
  std::vector<bool> is_pushed_;              // nv, true if the controller applies a force
  Stepper stepper_;
};

}  // namespace mjforge::physics
