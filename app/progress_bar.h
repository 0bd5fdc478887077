#pragma once

#include <chrono>

#include "mjforge/batch/batch.h"

namespace mjforge::app {

/// One line that shows how far a batch is; only on a terminal.
class ProgressBar {
 public:
  /// Shows nothing unless `enabled` and standard error is a terminal.
  explicit ProgressBar(bool enabled);
  /// Takes the line away.
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
