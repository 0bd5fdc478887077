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
  int status = 0;          // exit status; 128 + signal if a signal killed it, as a shell says it
  std::string out;         // standard output
  std::string err;         // standard error
  bool timed_out = false;  // it was killed, with all processes it started
};

/// One run of a program as a user would start it, with the tester's environment
/// but for what changes the program's words: NO_COLOR, MJFORGE_PATH and locale
/// are unset unless given.
struct Command {
  std::filesystem::path program;  // looked up in PATH if it has no folder
  std::vector<std::string> arguments;
  std::string input = {};  // standard input
  std::map<std::string, std::string> environment = {};
  std::filesystem::path folder = ".";
  std::chrono::milliseconds timeout = std::chrono::minutes(1);

  /// Runs it to its end. Fails the test if it cannot be started.
  CommandResult Run() const;
};

/// The mjforge that was built with these tests.
std::filesystem::path MjforgeProgram();

/// For TEST_CASE_METHOD: mjforge in a fresh folder.
class ProgramTest {
 protected:
  CommandResult Run(std::vector<std::string> arguments, std::string input = {},
                    std::map<std::string, std::string> environment = {}) const;
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

}  // namespace mjforge::harness
