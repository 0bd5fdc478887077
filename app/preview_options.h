// Options of `mjforge preview`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mjforge/picture/picture.h"
#include "options.h"

namespace mjforge::app {

/// A joint's name and the position that the command line gives it.
struct JointPosition {
  std::string name;
  double value = 0;  // rad or m
  expr::Dimension dimension;
};

struct PreviewOptions {
  std::vector<std::string> whats;  // a spec, or one or several files
  std::string what;                // the first of `whats`
  std::uint64_t count = 1;
  std::uint64_t first = 0;
  std::string output;
  std::string size;
  std::string layer = "visual";
  std::string background = "studio";
  std::vector<std::string> joints;  // NAME=EXPRESSION
  bool sweep = false;
  bool watch = false;
  Seconds time_limit{600};
  bool force = false;
  SpecOptions spec;

  // Results of ResolvePreviewOptions.
  bool is_file = false;
  picture::Options picture;  // `view` is set by the command line
  std::vector<JointPosition> poses;
  std::string swept;  // the joint to sweep; empty: all joints
};

void AddPreviewOptions(CLI::App& command, PreviewOptions& options);

/// Parses the texts of the options. Returns the error message for a wrong option or for options
/// that contradict each other; an empty text if there are none.
std::string ResolvePreviewOptions(PreviewOptions& options);

}  // namespace mjforge::app
