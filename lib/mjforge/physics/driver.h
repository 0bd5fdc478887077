#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/physics/coupling.h"
#include "mjforge/physics/drive.h"
#include "mjforge/physics/stepper.h"
#include "mjforge/physics/travel.h"

namespace mjforge::physics {

/// Drives joints of a model without gravity and loose roots; `m` and its data `d` must outlive it.
class Driver {
 public:
  Driver(mjModel& m, mjData& d);

  const Couplings& couplings() const { return couplings_; }

  /// Puts the joints where `start` (nq) has them.
  void Begin(std::span<const mjtNum> start);

  /// Bodies that are in each other there.
  std::vector<Jam> Jams() const;

  /// All at the same time.
  std::vector<Driven> Run(std::span<const int> joints);

 private:
  using Bodies = std::pair<int, int>;  // the lower number first

  /// A path that is being driven.
  struct Ride {
    Path path;
    Driven* driven = nullptr;
    std::vector<bool> moved;  // bodies
    double home = 0;          // where it is to end
    double from = 0;          // this move's ends, with the push beyond the range
    double to = 0;
    double nearest = 0;  // that it came to the move's end
    double held = 0;     // s, since it last came nearer
    bool counts = true;  // whether what is beyond the range counts
    double lowest = 0;
    double highest = 0;

    double End() const { return std::clamp(to, path.low, path.high); }
  };

  void Reset();
  /// How deep bodies of one object are in each other, m.
  std::map<Bodies, double> DepthsNow() const;
  void Follow(std::vector<Ride>& rides);
  void Start(Ride& ride);
  void Finish(const Ride& ride);
  /// One move of each.
  void Go(std::vector<Ride>& rides);
  double InertiaOf(int dof);
  void SetForces(const std::vector<Ride>& rides, const Move& progress);
  static Move Target(const Ride& ride, const Move& progress);
  std::optional<Move> MoveOfOther(const std::vector<Ride>& rides, int joint,
                                  const Move& progress) const;
  void Push(int joint, int axis, const std::array<double, 3>& errors, double most,
            const Move& move);
  std::array<double, 3> Errors(int joint, int axis, double target) const;
  std::array<double, 3> ErrorsOfHeld(int joint, double target) const;
  double StartOf(int joint) const;
  double Force(int dof, double error, double speed, double acceleration) const;
  double Value(const Path& path) const;
  void Look(std::vector<Ride>& rides);

  mjModel& m_;
  mjData& d_;
  Couplings couplings_;
  std::vector<mjtNum> start_;      // nq
  std::map<Bodies, double> jams_;  // m, where they start
  std::vector<double> inertia_;    // nv, about its own axis
  Stepper stepper_;
};

}  // namespace mjforge::physics
