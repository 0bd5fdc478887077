#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/picture/picture.h"
#include "options.h"

namespace mjforge::app {

/// The options of `preview`.
struct PreviewOptions {
  std::string what;  // a spec or a file
  std::uint64_t count = 1;
  std::uint64_t first = 0;
  std::string output;
  std::string size;
  std::string layer = "visual";
  std::string background = "studio";
  std::vector<std::string> joints;  // name=expression
  bool sweep = false;
  std::chrono::duration<double> time_limit{600};
  bool force = false;
  SpecOptions spec;

  // Filled in by Understand.
  bool is_file = false;
  picture::Options picture;                           // `view` is told
  std::vector<std::pair<std::string, double>> poses;  // of joints, rad, m
  std::string swept;                                  // a joint; empty: each of them
};

void AddPreviewOptions(CLI::App& command, PreviewOptions& options);

/// Returns how the options contradict each other, or nothing.
std::string Understand(PreviewOptions& options);

}  // namespace mjforge::app
