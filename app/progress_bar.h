// Line on a terminal that shows the progress of a batch.
#pragma once

#include <chrono>

#include "mjforge/batch/batch.h"

namespace mjforge::app {

/// Line on standard error with the progress of a batch, written over its previous state.
class ProgressBar {
 public:
  /// Shows the line only if `enabled` and standard error is a terminal.
  explicit ProgressBar(bool enabled);
  /// Clears the line.
  ~ProgressBar() { Clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void Show(const batch::Summary& summary);
  void Clear();

 private:
  bool enabled_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace mjforge::app
