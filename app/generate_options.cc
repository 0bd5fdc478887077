// Options of `mjforge generate`, their conversion to a request, and conflicts between options.
#include "generate_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <limits>

#include "completion.h"
#include "family_option_conflicts.h"

namespace mjforge::app {
namespace {

using Kind = output::Destination::Kind;

constexpr std::uint64_t kMaxShards = 99'999;  // file names have five digits for a shard

// Parses the index and the count of a shard: "3/8".
std::optional<output::Shard> ParseShard(std::string_view text, std::string& why_not) {
  const std::size_t slash = text.find('/');
  const std::optional<std::uint64_t> index = output::ReadIndex(text.substr(0, slash));
  const std::optional<std::uint64_t> count =
      slash == text.npos ? std::nullopt : output::ReadIndex(text.substr(slash + 1));
  if (!index || !count || *count == 0 || *count > kMaxShards)
    return diag::Refuse(
        why_not, fmt::format("--shard: '{}' is not of the form I/N, N up to {}", text, kMaxShards));
  if (*index >= *count)
    return diag::Refuse(
        why_not, fmt::format("--shard {}: shards count from 0, so the last one is {}/{}", text,
                             *count - 1, *count));
  return output::Shard{*index, *count};
}

// Returns the message for an option that the destination does not support; empty if there is none.
std::string FindConflict(const GenerateOptions& options, const batch::Request& request) {
  const Kind kind = request.destination.kind;
  const bool is_one = request.destination.TakesOne();
  if (is_one && request.count > 1)
    return fmt::format("-o {} takes one variant, -n asks for {}", options.output, request.count);
  if (kind != Kind::kFolder && options.specs.size() > 1)
    return fmt::format("-o {} takes one spec, {} are given", options.output, options.specs.size());
  if (kind == Kind::kStandardOutput && request.variant.assets == mjcf::AssetForm::kFiles)
    return "--assets files: standard output cannot carry them; write to a file, a folder or an "
           "archive";
  if (is_one && request.resume) return fmt::format("-o {} has nothing to resume", options.output);
  if (is_one && !request.shard.IsWhole())
    return fmt::format("-o {} writes one variant, which has no shards", options.output);
  if (kind == Kind::kArchive && !request.shard.IsWhole()) {
    return fmt::format(
        "--shard: '{}' is one archive; shards fill a folder or a series, such as '{}'",
        options.output, std::string(options.output).insert(options.output.rfind(".tar"), "_%05d"));
  }
  if (options.has_per_archive && kind != Kind::kArchives)
    return fmt::format("--per-archive is for a series, such as -o 'x_%05d.tar', not for -o {}",
                       options.output);
  if (request.verify && !request.resume) return "--verify is for --resume; see `mjforge verify`";
  return {};
}

// Returns an error message if a manifest, which is UTF-8, could not contain the name of a file. The
// names of its folders are not in a manifest.
std::string FindNotUtf8(const GenerateOptions& options) {
  std::vector<std::string> names = options.specs;
  names.push_back(options.output);
  for (const std::string& path : names) {
    const std::string name = std::filesystem::path(path).filename().string();
    for (std::string_view rest = name; !rest.empty();) {
      const diag::Utf8Char character = diag::DecodeUtf8(rest);
      if (!character.valid)
        return fmt::format("'{}' is not UTF-8, as manifests are", diag::SafeText(name));
      rest.remove_prefix(character.length);
    }
  }
  return {};
}

// Returns an error message if --each contradicts other options; otherwise an empty text.
std::string FindEachConflict(const GenerateOptions& options, const batch::Request& request) {
  if (!request.variant.each) return {};
  if (request.destination.TakesOne())
    return fmt::format("--each writes several files: -o {} must be a folder or an archive",
                       options.output);
  if (!mjcf::RulesOf(request.variant.target).has_scene) return {};
  std::vector<std::string_view> targets = mjcf::TargetNames();
  std::erase(targets, options.target);
  return fmt::format("--each: files for --target {} have a floor of their own; the targets are {}",
                     options.target, fmt::join(targets, ", "));
}

// Returns an error message if --layout contradicts other options; otherwise an empty text.
std::string FindLayoutConflict(const GenerateOptions& options, const batch::Request& request) {
  if (request.variant.layout == manifest::Layout::kAny) return {};
  if (request.variant.validation == manifest::Validation::kNone)
    return fmt::format(
        "--layout {} reads structures from the models that MuJoCo loads, and "
        "--validate none loads none",
        options.layout);
  if (request.variant.layout == manifest::Layout::kSplit && request.destination.TakesOne())
    return fmt::format("--layout split makes folders: -o {} must be a folder or an archive",
                       options.output);
  return {};
}

std::string FindMakeConflict(const GenerateOptions& options, const batch::Request& request) {
  const MakeOptions& make = options.make;
  if (!make.wanted() && (make.phony || !make.targets.empty()))
    return make.phony ? "-MP needs -MD" : "-MT needs -MD";
  if (!make.wanted()) return {};
  if (options.specs.size() > 1) return "-MD takes one spec";
  if (request.resume) return "-MD and --resume: the inputs of kept variants are not known";
  if (!request.shard.IsWhole()) return "-MD and --shard: a shard is not a target by itself";
  if (request.destination.kind == Kind::kStandardOutput &&
      (make.file.empty() || make.targets.empty())) {
    return "-MD with -o - needs -MF and -MT";
  }
  return {};
}

void AddOutputOptions(CLI::App& command, GenerateOptions& options) {
  command
      .add_option("-o,--output", options.output,
                  "Folder [./NAME/], .xml, .npz, .tar[.zst], %d.tar -")
      ->option_text("OUT")
      ->check([](const std::string& text) { return text.empty() ? "'' is no place" : ""; }, "")
      ->check(Offers("."));
  AddWholeNumber(command, "--per-archive", options.per_archive, "Variants in each archive", 1)
      ->each([&options](const std::string&) { options.has_per_archive = true; });
  command.add_option("--shard", options.shard, "Part I (from 0) of the N parts of the batch")
      ->option_text("I/N");
  command.add_flag("--resume", options.request.resume, "Continue what an earlier run left");
  command.add_flag("--verify", options.request.verify,
                   "With --resume: read finished archives, too");
  AddWord(command, "--durability", options.durability, output::kDurabilities,
          "What outlives a power cut");
  command.add_flag("--if-changed", options.request.if_changed, "Leave unchanged files alone");
  command.add_flag("--force", options.request.force, "Overwrite files that mjforge did not make");
}

}  // namespace

void AddGenerateOptions(CLI::App& command, GenerateOptions& options) {
  AddBatchOptions(command, options);
  AddWholeNumber(command, "--first", options.request.first, "Index of the first variant");
  AddOutputOptions(command, options);
  command.add_option("--name", options.request.variant.name, "The object's name; ${index} allowed")
      ->option_text("TEXT")
      ->check([](const std::string& text) { return text.empty() ? "'' is no name" : ""; }, "");
  AddWord(command, "--target", options.target, mjcf::TargetNames(), "For");
  command.add_flag("--each", options.request.variant.each, "Each object of a scene as a file");
  command.add_flag("--mocap", options.request.variant.mocap, "In a family: fixed bodies are mocap");
  command.add_flag("--pad", options.request.variant.pad,
                   "In a family: geoms that a variant lacks are null");
  AddWord(command, "--assets", options.assets, mjcf::kAssetForms, "Meshes and textures");
  AddWord(command, "--validate", options.validate, manifest::kValidations, "MuJoCo's verdict");
  AddProfile(command, options.spec.settings, [&options] { options.validate = "physics"; });
  AddWord(command, "--on-invalid", options.on_invalid, manifest::kOnInvalid, "Invalid variants");
  AddWord(command, "--layout", options.layout, manifest::kLayouts, "Structures of compiled models");
  AddWord(command, "--sampler", options.sampler, sample::MethodNames(), "Spread of draws");
  AddWholeNumber(command, "--batch", options.request.variant.batch,
                 "Variants the draws are spread over", 1)
      ->option_text("N [-n]");
  AddMakeOptions(command, options.make);
  command.add_flag("-v,--verbose", options.verbose, "Print a line per variant");
}

std::optional<batch::Request> RequestOf(const GenerateOptions& options, std::string& why_not) {
  batch::Request request = RequestOf(static_cast<const BatchOptions&>(options));
  request.variant.target = *mjcf::FindTarget(options.target);
  request.variant.assets = *manifest::Find<mjcf::AssetForm>(options.assets);
  request.variant.sampler = *sample::FindMethod(options.sampler);
  request.variant.validation = *manifest::Find<forge::Validation>(options.validate);
  request.variant.layout = *manifest::Find<manifest::Layout>(options.layout);
  request.variant.on_invalid = *manifest::Find<forge::OnInvalid>(options.on_invalid);
  request.durability =
      options.durability == "none" ? output::Durability::kNone : output::Durability::kBatch;
  request.all_or_nothing = options.make.wanted();
  const auto destination = output::ParseDestination(options.output, options.per_archive, why_not);
  if (!destination) return diag::Refuse(why_not, fmt::format("-o {}: {}", options.output, why_not));
  request.destination = *destination;
  if (!options.shard.empty()) {
    const std::optional<output::Shard> shard = ParseShard(options.shard, why_not);
    if (!shard) return std::nullopt;
    request.shard = *shard;
  }
  // The index after the last index must not overflow.
  if (request.count > std::numeric_limits<std::uint64_t>::max() - request.first) {
    why_not = "--first and -n go beyond the largest index";
  } else if (request.variant.batch > sample::kMaxBatch) {
    why_not = fmt::format("draws are spread over at most {} variants", sample::kMaxBatch);
  } else {
    why_not = FindConflict(options, request);
    if (why_not.empty()) why_not = FindNotUtf8(options);
    if (why_not.empty()) why_not = FindMakeConflict(options, request);
    if (why_not.empty()) why_not = FindEachConflict(options, request);
    if (why_not.empty()) why_not = FindLayoutConflict(options, request);
    if (why_not.empty()) why_not = FindFamilyConflict(options.output, request);
  }
  return why_not.empty() ? std::optional(std::move(request)) : std::nullopt;
}

}  // namespace mjforge::app
