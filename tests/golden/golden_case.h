// Specs with the bytes that are generated from them: tests/golden/good.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mjforge::golden {

/// A folder with a spec, the command that is run in a copy of it, and what must
/// come out, to the byte:
///   command       one shell line; absent: `mjforge generate spec.yaml --seed 1 -o -`
///   expected.xml  standard output; standard error is empty and the status 0
///   expected.txt  both outputs as a terminal shows them, then `exit: STATUS`
struct GoldenCase {
  std::filesystem::path folder;
  std::string command;

  /// Returns the file with what is expected; empty if there is none.
  std::filesystem::path ExpectedFile() const;
};

/// All cases, sorted by folder.
std::vector<GoldenCase> GoodCases();

/// Runs a case and compares. With MJFORGE_UPDATE=1 it writes what came out as
/// the new expectation and fails nevertheless, so that an update is never a pass.
void CheckCase(const GoldenCase& golden);

}  // namespace mjforge::golden
