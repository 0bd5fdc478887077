#pragma once

// -MD -MF -MT -MP, as compilers have them.

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

/// The words of a command line with those options as the parser takes them:
/// "-MF", "x.d" and "-MFx.d" become "--MF", "x.d" and "--MF=x.d".
std::vector<std::string> WithLongMakeOptions(std::vector<std::string> words);
/// The reverse, in a help text.
std::string WithShortMakeOptions(std::string text);

/// Writes the rule. Files below the current folder get relative paths, or all get absolute ones if
/// `absolute`. False and a finding if it cannot be written.
bool WriteDependencies(const MakeOptions& options, const output::Destination& destination,
                       const std::set<std::string>& files, bool absolute, bool force,
                       diag::Findings& findings);

}  // namespace mjforge::app
