#pragma once

#include <chrono>
#include <string>

#include "console.h"

namespace mjforge::app {

/// While it lives, the program ends with a finding once it has taken more CPU time than `limit`:
/// for the loading of the spec `what`, before anything is written. One at a time.
class LoadLimit {
 public:
  LoadLimit(const std::string& what, std::chrono::duration<double> limit, const Console& console);
  LoadLimit(const LoadLimit&) = delete;
  LoadLimit& operator=(const LoadLimit&) = delete;
  ~LoadLimit();
};

}  // namespace mjforge::app
