#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "harness/command.h"
#include "harness/temporary_folder.h"

namespace mjforge::make {

/// docs/examples/make in the source tree.
std::filesystem::path Example();

/// A copy of the example, to build with the mjforge under test.
class Project {
 public:
  Project();

  const harness::TemporaryFolder& folder() const { return folder_; }
  /// Runs a program in it.
  harness::CommandResult Run(const std::string& program, std::vector<std::string> arguments) const;
  /// The same, and fails the test if the program fails; returns what it said.
  std::string Do(const std::string& program, std::vector<std::string> arguments) const;

  /// Gives every file the same time in the past, so that nothing is newer than another.
  void Age();
  /// Writes this file again, the same. All others get a time in the past. The clock is that of
  /// the file system: a program's own may be ahead of it.
  void Touch(std::string_view name);
  /// Replaces text that is in the file. All others get a time in the past.
  void Change(std::string_view name, std::string_view from, std::string_view to);
  /// Targets below this folder that were written since: not rules, assets or variants of a folder.
  std::set<std::string> Fresh(std::string_view below) const;

 private:
  harness::TemporaryFolder folder_;
  std::filesystem::file_time_type past_;
};

}  // namespace mjforge::make
