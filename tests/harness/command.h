// Running programs in tests.

#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/temporary_folder.h"

namespace mjforge::harness {

struct CommandResult {
  int status = 0;          // exit status; 128 + signal if a signal killed the program
  std::string out;         // standard output
  std::string err;         // standard error
  bool timed_out = false;  // the program and its children were killed
};

/// A program to run. NO_COLOR, MJFORGE_PATH and the locale, which would change its output, are
/// removed from the inherited environment unless `environment` has them.
struct Command {
  std::filesystem::path program;  // searched in PATH if it has no folder
  std::vector<std::string> arguments;
  std::string input = {};  // standard input
  std::map<std::string, std::string> environment = {};
  std::filesystem::path folder = ".";
  std::chrono::milliseconds timeout = std::chrono::minutes(1);

  /// Runs the program to its end. Fails the test if the program cannot be started.
  CommandResult Run() const;
};

/// Returns the mjforge that was built with these tests.
std::filesystem::path MjforgeProgram();

/// Fixture for TEST_CASE_METHOD that runs mjforge in a new temporary folder.
class ProgramTest {
 protected:
  CommandResult Run(std::vector<std::string> arguments, std::string input = {},
                    std::map<std::string, std::string> environment = {}) const;
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

}  // namespace mjforge::harness
