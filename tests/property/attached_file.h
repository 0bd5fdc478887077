// An MJCF file and its attached bodies, compiled by MuJoCo for comparison.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mjforge/attach/attach.h"
#include "mjforge/engine/engine.h"

namespace mjforge::attach {

/// Compiled model of a file, and of objects with a body of that file attached.
class AttachedFile {
 public:
  explicit AttachedFile(std::filesystem::path file);

  /// Returns true if MuJoCo loads the unchanged file.
  bool Loads() const { return own_.model != nullptr; }
  const std::string& why_not() const { return own_.error; }
  const mjModel& own() const { return *own_.model; }

  /// Returns an otherwise empty object with this body attached; null if it cannot be attached.
  engine::Model Attach(int body);
  /// Findings of the last call of Attach, one per line.
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

/// Compares body 2 of the object with `body` of the file and its descendants; fails the test if
/// they differ. Returns the number of compared numbers.
int CompareAttached(const mjModel& own, int body, const mjModel& object);

}  // namespace mjforge::attach
