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
  void Move(const Pose& pose);
};

}  // namespace mjforge::picture
