// Limit of the CPU time for loading a spec.
#pragma once

#include <string>

#include "console.h"

namespace mjforge::app {

/// Ends the program with a finding if loading the spec `what` takes more CPU time than `limit`
/// during the lifetime of this object. Nothing must have been written yet. Only one instance at a
/// time.
class LoadLimit {
 public:
  LoadLimit(const std::string& what, Seconds limit, const Console& console);
  LoadLimit(const LoadLimit&) = delete;
  LoadLimit& operator=(const LoadLimit&) = delete;
  ~LoadLimit();
};

}  // namespace mjforge::app
