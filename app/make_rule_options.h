// Options -MD, -MF, -MT and -MP, which write a Make rule like those of compilers.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/output/output.h"

namespace CLI {
class App;
}  // namespace CLI

namespace mjforge::app {

struct MakeOptions {
  bool dependencies = false;         // -MD
  std::string file;                  // -MF; empty: beside the output
  std::vector<std::string> targets;  // -MT; empty: the output
  bool phony = false;                // -MP

  bool wanted() const { return dependencies || !file.empty(); }
};

void AddMakeOptions(CLI::App& command, MakeOptions& options);

/// Rewrites -MD, -MF, -MT and -MP as long options, because CLI11 has only one-letter short options:
/// "-MF", "x.d" and "-MFx.d" become "--MF", "x.d" and "--MF=x.d".
std::vector<std::string> WithLongMakeOptions(std::vector<std::string> words);
/// Converts "--MF" to "-MF" in a help text.
std::string WithShortMakeOptions(std::string text);

/// Returns true if WriteDependencies() may write its file: no other file has its name, unless
/// `force`. Otherwise adds a finding.
bool MayWriteDependencies(const MakeOptions& options, const output::Destination& destination,
                          bool force, diag::Findings& findings);

/// Writes the Make rule for the output at `destination`, which depends on `files`, or prints the
/// rule with `-MF -`. Paths of files below the current folder are relative, unless `absolute`.
/// Returns false and adds a finding on failure.
bool WriteDependencies(const MakeOptions& options, const output::Destination& destination,
                       const std::set<std::string>& files, bool absolute, bool force,
                       diag::Findings& findings);

}  // namespace mjforge::app
