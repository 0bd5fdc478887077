#include "generate_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <limits>

#include "mjforge/expr/expr.h"

namespace mjforge::app {
namespace {

using Kind = output::Destination::Kind;

// As many digits as a shard's manifest has in its name.
constexpr std::uint64_t kMostShards = 99'999;

// "3/8"
std::optional<output::Shard> ParseShard(std::string_view text, std::string& why_not) {
  const std::size_t slash = text.find('/');
  const std::optional<std::uint64_t> index = ParseWhole(text.substr(0, slash));
  const std::optional<std::uint64_t> count =
      slash == text.npos ? std::nullopt : ParseWhole(text.substr(slash + 1));
  if (!index || !count || *count == 0 || *count > kMostShards) {
    why_not = fmt::format("--shard: '{}' is not of the form I/N, N up to {}", text, kMostShards);
    return std::nullopt;
  }
  if (*index >= *count) {
    why_not = fmt::format("--shard {}: shards count from 0, so the last one is {}/{}", text,
                          *count - 1, *count);
    return std::nullopt;
  }
  return output::Shard{*index, *count};
}

// Options that one object's destination or a folder has no use for.
std::string Misplaced(const GenerateOptions& options, const batch::Request& request) {
  const Kind kind = request.destination.kind;
  const bool is_one = kind == Kind::kFile || kind == Kind::kStandardOutput;
  if (is_one && options.count > 1)
    return fmt::format("-o {} takes one variant, -n asks for {}", options.output, options.count);
  if (kind != Kind::kFolder && options.specs.size() > 1)
    return fmt::format("-o {} takes one spec, {} are given", options.output, options.specs.size());
  if (is_one && options.resume) return fmt::format("-o {} has nothing to resume", options.output);
  if (is_one && !request.shard.IsWhole())
    return fmt::format("-o {} is one variant, which has no shards", options.output);
  if (kind == Kind::kArchive && !request.shard.IsWhole()) {
    return fmt::format(
        "--shard: '{}' is one archive; shards fill a folder or a series, such as '{}'",
        options.output, std::string(options.output).insert(options.output.find(".tar"), "_%05d"));
  }
  return {};
}

std::string MisplacedMake(const GenerateOptions& options, const batch::Request& request) {
  const MakeOptions& make = options.make;
  if (!make.wanted()) return {};
  if (options.specs.size() > 1) return "-MD takes one spec";
  if (options.resume) return "-MD and --resume: what kept variants were made from is not known";
  if (!request.shard.IsWhole()) return "-MD and --shard: a shard is no target of its own";
  if (request.destination.kind == Kind::kStandardOutput &&
      (make.file.empty() || make.targets.empty())) {
    return "-MD with -o - needs -MF and -MT";
  }
  return {};
}

std::vector<std::string> TargetNames() {
  std::vector<std::string> names;
  for (const mjcf::TargetRules& info : mjcf::Targets()) names.emplace_back(info.name);
  return names;
}

template <typename Enum>
std::vector<std::string> WordsOf() {
  const auto words = manifest::WordsOf(Enum());
  return {words.begin(), words.end()};
}

std::vector<std::string> SamplerNames() {
  const auto names = sample::MethodNames();
  return {names.begin(), names.end()};
}

void AddOutputOptions(CLI::App& command, GenerateOptions& options) {
  command
      .add_option("-o,--output", options.output, "A folder [./NAME/], .xml, .tar[.zst], %d.tar, -")
      ->option_text("OUT");
  AddWholeNumber(command, "--per-archive", options.per_archive, "Variants in each archive", 1);
  command.add_option("--shard", options.shard, "Part I (from 0) of the N parts of the batch")
      ->option_text("I/N");
  command.add_flag("--resume", options.resume, "Go on with what an earlier run left");
  command.add_flag("--if-changed", options.if_changed, "Leave files alone that stay the same");
  command.add_flag("--force", options.force, "Overwrite files that mjforge did not make");
}

void AddTimeLimit(CLI::App& command, double& limit) {
  const auto parse = [](const std::string& text) {
    const std::optional<double> seconds = expr::ParseNumber(text);
    return seconds && *seconds > 0 && *seconds < 1e9 ? seconds : std::nullopt;
  };
  command
      .add_option_function<std::string>(
          "--time-limit", [&limit, parse](const std::string& text) { limit = *parse(text); },
          "Most time for one variant, s")
      ->check([parse](const std::string& text) {
        return parse(text) ? std::string()
                           : fmt::format("'{}' is not a time in seconds above 0", text);
      })
      ->option_text(fmt::format("S [{:g}]", limit));
}

}  // namespace

void AddGenerateOptions(CLI::App& command, GenerateOptions& options) {
  command.add_option("SPEC", options.specs, "A file, a name in the catalogue, or - (stdin)")
      ->required()
      ->option_text("...");
  AddWholeNumber(command, "-n,--count", options.count, "Variants to make", 1);
  AddWholeNumber(command, "-s,--seed", options.seed, "Seed of all draws");
  AddWholeNumber(command, "--first", options.first, "Index of the first variant");
  AddJobs(command, options.jobs);
  AddOutputOptions(command, options);
  command.add_option("--name", options.name, "The object's name; ${index} allowed")
      ->option_text("TEXT");
  AddSpecOptions(command, options.spec);
  AddWord(command, "--target", options.target, TargetNames(), "For");
  AddWord(command, "--validate", options.validate, WordsOf<forge::Validation>(),
          "MuJoCo's verdict");
  AddWord(command, "--on-invalid", options.on_invalid, WordsOf<forge::OnInvalid>(), "Bad variants");
  AddTimeLimit(command, options.time_limit);
  AddWord(command, "--sampler", options.sampler, SamplerNames(), "How draws are spread");
  AddWholeNumber(command, "--batch", options.batch, "Variants they are spread over", 1)
      ->option_text("N [-n]");
  AddMakeOptions(command, options.make);
  AddReportOptions(command, options.report);
  AddVerboseOption(command, options.report);
}

std::optional<batch::Request> RequestOf(const GenerateOptions& options, std::string& why_not) {
  batch::Request request;
  request.first = options.first;
  request.count = options.count;
  request.variant.seed = options.seed;
  request.variant.target = *mjcf::FindTarget(options.target);
  request.variant.name = options.name;
  request.variant.sampler = *sample::FindMethod(options.sampler);
  request.variant.batch = options.batch == 0 ? options.count : options.batch;
  request.variant.on_invalid = *manifest::Find<forge::OnInvalid>(options.on_invalid);
  request.variant.validation = *manifest::Find<forge::Validation>(options.validate);
  request.force = options.force;
  request.if_changed = options.if_changed;
  request.resume = options.resume;
  request.all_or_nothing = options.make.wanted();
  request.jobs = options.jobs;
  request.time_limit = std::chrono::duration<double>(options.time_limit);
  if (options.count - 1 > std::numeric_limits<std::uint64_t>::max() - options.first) {
    why_not = "--first and -n lead beyond the largest index";
    return std::nullopt;
  }
  if (request.variant.batch > sample::kMaxBatch) {
    why_not = fmt::format("draws are spread over at most {} variants", sample::kMaxBatch);
    return std::nullopt;
  }
  const auto destination = output::ParseDestination(options.output, options.per_archive, why_not);
  if (!destination) {
    why_not = fmt::format("-o {}: {}", options.output, why_not);
    return std::nullopt;
  }
  request.destination = *destination;
  if (!options.shard.empty()) {
    const std::optional<output::Shard> shard = ParseShard(options.shard, why_not);
    if (!shard) return std::nullopt;
    request.shard = *shard;
  }
  why_not = Misplaced(options, request);
  if (why_not.empty()) why_not = MisplacedMake(options, request);
  if (!why_not.empty()) return std::nullopt;
  return request;
}

}  // namespace mjforge::app
