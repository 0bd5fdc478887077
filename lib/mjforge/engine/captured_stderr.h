// Capture of the text that C libraries print to `stderr`.
#pragma once

#include <string>
#include <vector>

namespace mjforge::engine {

/// Captures the text that is printed to the C library's `stderr` while the object exists, because
/// Qhull, which computes convex hulls for MuJoCo, prints its messages there. The file descriptor 2
/// is unchanged.
class CapturedStderr {
 public:
  CapturedStderr();
  ~CapturedStderr();
  CapturedStderr(const CapturedStderr&) = delete;
  CapturedStderr& operator=(const CapturedStderr&) = delete;

  /// Returns Qhull's messages, without the details that follow each: "Initial simplex is flat" for
  /// "QH6154 Qhull precision error: Initial simplex is flat".
  std::vector<std::string> QhullMessages() const;

 private:
  std::string text_;
};

}  // namespace mjforge::engine
