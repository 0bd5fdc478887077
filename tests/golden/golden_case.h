#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mjforge::golden {

/// A folder with a spec, the command that is run in a copy of it, and what must
/// come out, to the byte:
///   command       one shell line; absent: the default of the case's kind
///   expected.xml  standard output; standard error is empty and the status 0
///   expected.txt  both outputs as a terminal shows them, then `exit: STATUS`
struct GoldenCase {
  std::filesystem::path folder;
  std::string name;  // "errors/spec-unknown-key"
  std::string command;

  /// The file that says what is expected; empty if there is none.
  std::filesystem::path ExpectedFile() const;
};

/// All cases below tests/golden/KIND ("errors", "good"), sorted. A case is a folder
/// with a spec or a command; it may have folders of its own, which are no cases.
std::vector<GoldenCase> FindCases(const std::string& kind, const std::string& default_command);

/// Runs a case and compares. With MJFORGE_UPDATE=1 it writes what came out as
/// the new expectation and fails nevertheless, so that an update is never a pass.
void CheckCase(const GoldenCase& golden);

}  // namespace mjforge::golden
