#ifndef MJFORGE_APP_GENERATE_OPTIONS_H_
#define MJFORGE_APP_GENERATE_OPTIONS_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/batch/batch.h"
#include "options.h"

namespace mjforge::app {

/// What `generate` is told.
struct GenerateOptions {
  std::vector<std::string> specs;
  std::uint64_t count = 1;
  std::uint64_t seed = 0;
  std::uint64_t first = 0;
  std::uint64_t jobs = 0;
  std::string output;
  std::uint64_t per_archive = 10'000;
  std::string shard;
  std::string name;
  std::string target = "mujoco";
  std::string validate = "load";
  std::string on_invalid = "fail";
  std::string sampler = "random";
  std::uint64_t batch = 0;
  double time_limit = 30;
  bool resume = false;
  bool if_changed = false;
  bool force = false;
  SpecOptions spec;
  MakeOptions make;
  ReportOptions report;
};

void AddGenerateOptions(CLI::App& command, GenerateOptions& options);

/// The options as a batch takes them, but for a folder's name that the spec says;
/// nothing, and why, if they contradict each other.
std::optional<batch::Request> RequestOf(const GenerateOptions& options, std::string& why_not);

}  // namespace mjforge::app

#endif  // MJFORGE_APP_GENERATE_OPTIONS_H_
