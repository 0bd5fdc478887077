// State of a subject (a model to be drawn): MuJoCo's mjModel and mjData.

#pragma once

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/picture/picture.h"

namespace mjforge::picture {

struct Subject::State {
  engine::Model model;
  compiled::Data data;

  /// Computes the poses, centres of mass, cameras, lights and tendons for the present qpos.
  void Update();
  /// Sets the positions of some joints, and calls Update().
  void Move(const JointPositions& pose);
  /// Sets all positions (qpos, nq numbers), and calls Update().
  void Move(const std::vector<double>& positions);
};

}  // namespace mjforge::picture
