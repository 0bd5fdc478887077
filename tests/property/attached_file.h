#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjforge/attach/attach.h"
#include "mjforge/engine/engine.h"

namespace mjforge::attach {

/// A file as MuJoCo compiles it, and its bodies as MuJoCo compiles them in an
/// otherwise empty object.
class AttachedFile {
 public:
  explicit AttachedFile(std::filesystem::path file);

  /// Does MuJoCo load the file by itself?
  bool Loads() const { return own_.model != nullptr; }
  const std::string& why_not() const { return own_.error; }
  const mjModel& own() const { return *own_.model; }

  /// The object with this body; null if it cannot be attached.
  engine::Model Attach(int body);
  /// Why the last could not, one line a finding.
  const std::string& findings() const { return text_; }
  bool refused() const { return refused_; }

 private:
  std::filesystem::path file_;
  engine::Engine engine_;
  engine::Loaded own_;
  diag::Sources sources_;
  MjcfReader reader_;
  std::string text_;
  bool refused_ = false;
};

/// Fails where the object differs from what the file says of the body and all
/// below it. Returns how many numbers it compared.
int CompareAttached(const mjModel& own, int body, const mjModel& object);

}  // namespace mjforge::attach
