#ifndef MJFORGE_APP_PROGRESS_BAR_H_
#define MJFORGE_APP_PROGRESS_BAR_H_

#include <chrono>

#include "mjforge/batch/batch.h"

namespace mjforge::app {

/// One line on the terminal that shows how far a batch is; on no other output.
class ProgressBar {
 public:
  /// Not `enabled`, or standard error is no terminal: shows nothing.
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

/// "[#####.....]  50 %  500 of 1000  250/s  0:02 left  3 failed", at most `width`
/// columns. `seconds`: since the start of this run.
std::string ProgressLine(const batch::Summary& summary, double seconds, std::size_t width);

}  // namespace mjforge::app

#endif  // MJFORGE_APP_PROGRESS_BAR_H_
