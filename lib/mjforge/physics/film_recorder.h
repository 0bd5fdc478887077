// Recorder of a simulation for a film: positions at equal intervals of simulated time.
#pragma once

#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/physics/physics.h"

namespace mjforge::physics {

/// Records runs of a simulation as positions (qpos). Keep() makes a run a part of the film.
class FilmRecorder {
 public:
  /// Begins a run, and discards the previous run unless it was kept.
  void Begin();
  /// Records the positions if 5 ms of simulated time have passed since the run's last record. Must
  /// be called before each step.
  void Record(const mjModel& m, const mjData& d);
  /// Adds the current run to the film.
  void Keep();

  /// Returns at most `frames` positions of the kept runs, at equal intervals of simulated time.
  Film Finish(std::size_t frames) const;

 private:
  // Records of the kept runs and of the current run, each of nq positions.
  std::vector<std::vector<double>> kept_;
  std::vector<std::vector<double>> run_;
  double time_ = 0;       // s, simulated time since the run began
  double kept_time_ = 0;  // s, duration of the kept runs
};

}  // namespace mjforge::physics
