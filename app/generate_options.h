// Options of `mjforge generate`.
#pragma once

#include <optional>
#include <string>

#include "make_rule_options.h"
#include "options.h"

namespace mjforge::app {

struct GenerateOptions : BatchOptions {
  std::string output;
  std::uint64_t per_archive = 10'000;
  bool has_per_archive = false;  // --per-archive is given
  std::string shard;
  std::string target = "mujoco";
  std::string assets = "inline";
  std::string validate = "load";
  std::string on_invalid = "fail";
  std::string sampler = "random";
  std::string layout = "any";
  std::string durability = "batch";
  bool verbose = false;
  MakeOptions make;
};

void AddGenerateOptions(CLI::App& command, GenerateOptions& options);

/// Converts the options to a request. The caller sets the folder, because the spec may name it.
/// Returns nullopt and sets `why_not` if options contradict each other.
std::optional<batch::Request> RequestOf(const GenerateOptions& options, std::string& why_not);

}  // namespace mjforge::app
