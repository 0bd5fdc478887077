#ifndef MJFORGE_PICTURE_SUBJECT_H_
#define MJFORGE_PICTURE_SUBJECT_H_

#include <memory>

#include "mjforge/engine/engine.h"
#include "mjforge/picture/picture.h"

namespace mjforge::picture {

struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

struct Subject::State {
  engine::Model model;
  std::unique_ptr<mjData, DeleteData> data;

  /// Brings poses, centres of mass and tendons up to date with qpos.
  void Update();
  void Move(const Pose& pose);
};

}  // namespace mjforge::picture

#endif  // MJFORGE_PICTURE_SUBJECT_H_
