// Loads the recipe and the options with which a recorded variant was made.

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/forge/forge.h"

namespace mjforge::forge {
namespace {

// Returns the file of the record's spec, or the spec's recorded name if no file is found. Tries the
// recorded path first. Then looks for the name in the working directory, in the record's folder and
// one folder up, because the comment in a generated file has the name of the spec without its
// folder, and `generate` writes to a folder below the working directory by default.
std::string FindSpec(const manifest::Record& record, const std::filesystem::path& folder) {
  for (const std::filesystem::path& file :
       {folder / record.spec_file, std::filesystem::path(record.spec), folder / record.spec,
        folder / ".." / record.spec}) {
    if (bytes::IsFile(file)) return file.string();
  }
  return record.spec;
}

}  // namespace

std::optional<Recipe> LoadRecordedRecipe(const manifest::Record& record, const std::string& spec,
                                         const std::filesystem::path& folder,
                                         diag::Sources& sources, diag::Findings& findings) {
  const bool is_kept = !record.spec_file.empty() && bytes::IsFile(folder / record.spec_file);
  if (spec.empty() && record.spec == bytes::kStandardInput && !is_kept) {
    findings.Add(diag::Code::kSpecNotFound, {}, "the spec was read from standard input",
                 "pass its file with --spec");
    return std::nullopt;
  }
  spec::LoadOptions options = {.search_path = SearchPath()};
  for (const auto& [name, text] : record.settings) {
    options.settings.push_back({name, text, "the record's settings"});
  }
  const std::string reference = spec.empty() ? FindSpec(record, folder) : spec;
  diag::Findings found;
  std::optional<Recipe> recipe = LoadRecipe(reference, options, sources, found);
  for (const diag::Finding& finding : found) {
    diag::Finding& added = findings.Add(finding);
    const bool is_missing = spec.empty() && !finding.mark;
    if (is_missing && finding.code == diag::Code::kYamlCannotRead)
      added.hint = "pass its file with --spec";
  }
  if (!recipe) return std::nullopt;
  if (recipe->spec->sha256 != record.spec_sha256) {
    findings.Add(diag::Code::kOutputDiffers, {},
                 fmt::format("spec '{}' has changed since: its hash is {}, the record says {}",
                             recipe->spec->file, recipe->spec->sha256, record.spec_sha256),
                 "pass the original spec with --spec");
    return std::nullopt;
  }
  recipe->reference = record.spec;
  return recipe;
}

std::optional<Options> RecordedOptions(const manifest::Record& record, std::string_view what,
                                       diag::Findings& findings) {
  const auto unknown = [&](std::string_view kind, std::string_view name) {
    findings.Add(
        diag::Code::kOutputBadManifest, {},
        fmt::format("'{}' was made {} '{}', which this version does not know", what, kind, name));
    return std::nullopt;
  };
  const std::optional<mjcf::Target> target = mjcf::FindTarget(record.target);
  if (!target) return unknown("for target", record.target);
  const std::optional<sample::Method> sampler =
      record.sampler.empty() ? sample::Method::kRandom : sample::FindMethod(record.sampler);
  if (!sampler) return unknown("with sampler", record.sampler);
  const std::optional<mjcf::AssetForm> form =
      record.assets_as.empty() ? mjcf::AssetForm::kInline
                               : manifest::Find<mjcf::AssetForm>(record.assets_as);
  if (!form) return unknown("with assets as", record.assets_as);
  Options options;
  options.assets = *form;
  options.each = record.each || !record.part.empty();
  options.seed = record.seed;
  options.place_seed = record.place_seed;
  options.target = *target;
  options.name = record.name;
  options.attempt = record.attempt;
  options.sampler = *sampler;
  options.batch = record.batch;
  options.validation = record.validate;
  options.layout = record.layout;
  options.layout_first = record.layout_first.value_or(0);
  options.pad = record.pad;
  options.mocap = record.mocap;
  return options;
}

}  // namespace mjforge::forge
