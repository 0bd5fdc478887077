// Runs work that may crash or hang in several child processes at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "console.h"

namespace mjforge::app {

/// Work for RunInChildren: `count` steps, each with a result.
struct ParallelSteps {
  std::size_t count = 0;
  Seconds time_limit{600};  // for each step; see RunInChild
  /// Runs a step in a child process, and returns its result.
  std::function<std::string(std::size_t)> run;
  /// Returns the result of a step that crashed or exceeded a limit, for this reason.
  std::function<std::string(std::size_t, const std::string&)> explain;
  /// Receives a result in the parent process, in the order in which the steps end.
  std::function<void(std::size_t, std::string)> receive;
};

/// Runs the steps in `jobs` child processes (0: one per core). Results are cut off at about 160 kB.
/// Returns kInputOutput if a step needed too much memory. The caller must have no other threads.
ExitStatus RunInChildren(const ParallelSteps& steps, std::uint64_t jobs);

}  // namespace mjforge::app
