// Limits of CPU time and wall time for loading a spec.
#pragma once

#include <string>

#include "console.h"

namespace mjforge::app {

/// Ends the program with a finding if, during the lifetime of this object, loading the spec `what`
/// takes more CPU time than `limit`, or more wall time than batch::WallLimit(limit). No output file
/// may be open then, because the program ends at once. Only one instance may exist at a time.
class LoadTimeLimit {
 public:
  LoadTimeLimit(const std::string& what, Seconds limit, const Console& console);
  LoadTimeLimit(const LoadTimeLimit&) = delete;
  LoadTimeLimit& operator=(const LoadTimeLimit&) = delete;
  ~LoadTimeLimit();
};

}  // namespace mjforge::app
