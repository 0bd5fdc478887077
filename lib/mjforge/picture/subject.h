// State of a subject (a model to be drawn): MuJoCo's model and data.

#pragma once

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/picture/picture.h"

namespace mjforge::picture {

struct Subject::State {
  engine::Model model;
  compiled::Data data;

  /// Brings poses, centres of mass and tendons up to date with qpos.
  void Update();
  /// Sets the positions of joints, and updates.
  void Move(const JointPositions& pose);
  /// Sets all positions (nq), and updates.
  void Move(const std::vector<double>& positions);
};

}  // namespace mjforge::picture
