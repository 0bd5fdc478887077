#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>

#include "mjforge/forge/forge.h"

namespace mjforge::forge {
namespace {

// What is to be made again, and what it must be equal to.
struct Original {
  manifest::Record record;        // as far as it is known
  bool from_manifest = false;     // then `attempt`, `status` and `sha256` are known
  std::filesystem::path file;     // the object's; empty: none was written
  std::filesystem::path archive;  // that holds it; empty: it stands by itself
};

void AddBadManifest(diag::Findings& findings, std::string message, std::string hint = {}) {
  findings.Add(diag::Code::kOutputBadManifest, {}, std::move(message), std::move(hint));
}

// "out/manifest.jsonl:42" -> the file and 42; nothing if it ends otherwise.
std::optional<std::pair<std::string, std::uint64_t>> SplitIndex(const std::string& what) {
  const std::size_t colon = what.rfind(':');
  if (colon == std::string::npos || colon + 1 == what.size()) return std::nullopt;
  std::uint64_t index = 0;
  const char* end = what.data() + what.size();
  const auto [stop, error] = std::from_chars(what.data() + colon + 1, end, index);
  if (error != std::errc() || stop != end) return std::nullopt;
  return std::pair(what.substr(0, colon), index);
}

std::optional<Original> FromManifest(const std::filesystem::path& file, std::uint64_t index,
                                     diag::Findings& findings) {
  // Line by line: a manifest may have a hundred million.
  std::ifstream lines(file, std::ios::binary);
  if (!lines || std::filesystem::is_directory(file)) {
    output::ReadFile(file, findings);  // says why
    return std::nullopt;
  }
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::string why_not;
    std::optional<manifest::Record> record = manifest::ReadRecord(line, why_not);
    if (!record) {
      AddBadManifest(findings, fmt::format("line {} of '{}' is not a record: {}", number,
                                           file.string(), why_not));
      return std::nullopt;
    }
    if (record->index != index) continue;
    Original original{*std::move(record), true, {}, {}};
    const manifest::Record& known = original.record;
    if (!known.archive.empty()) {
      original.file = known.file;
      original.archive = file.parent_path() / known.archive;
    } else if (!known.file.empty()) {
      original.file = file.parent_path() / known.file;
    }
    return original;
  }
  AddBadManifest(findings, fmt::format("'{}' has no record of index {}", file.string(), index));
  return std::nullopt;
}

std::optional<Original> FromFile(const std::filesystem::path& file, diag::Findings& findings) {
  const std::optional<std::string> text = output::ReadFile(file, findings);
  if (!text) return std::nullopt;
  const std::optional<mjcf::Provenance> provenance = mjcf::ReadProvenance(*text);
  if (!provenance) {
    AddBadManifest(findings,
                   fmt::format("'{}' does not open with mjforge's comment", file.string()),
                   "only a file that mjforge wrote says how to make it again");
    return std::nullopt;
  }
  Original original;
  original.file = file;
  original.record.name = provenance->name;
  original.record.index = provenance->index;
  original.record.seed = provenance->seed;
  original.record.spec = provenance->spec;
  original.record.spec_sha256 = provenance->spec_sha256;
  original.record.settings = provenance->settings;
  original.record.target = provenance->target;
  original.record.sampler = provenance->sampler;
  original.record.batch = provenance->batch;
  return original;
}

// A record names a file without its folder, so it is looked for here, beside
// the record and one folder up, where generate's default puts the record's.
std::string FindSpec(const std::string& reference, const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const std::filesystem::path& place : {std::filesystem::path(), folder, folder / ".."}) {
    const std::filesystem::path file = place / reference;
    if (std::filesystem::is_regular_file(file, ignored)) return file.string();
  }
  return reference;
}

std::optional<Recipe> LoadOriginalRecipe(const Original& original, const ReplayRequest& request,
                                         const std::filesystem::path& folder,
                                         diag::Sources& sources, diag::Findings& findings) {
  const manifest::Record& record = original.record;
  if (request.spec.empty() && record.spec == "-") {
    findings.Add(diag::Code::kSpecNotFound, {}, "the spec was read from standard input",
                 "name its file with --spec");
    return std::nullopt;
  }
  spec::LoadOptions options;
  options.search_path = SearchPath();
  for (const auto& [name, text] : record.settings) {
    options.settings.push_back({name, text, "the record's settings"});
  }
  const std::string reference = request.spec.empty() ? FindSpec(record.spec, folder) : request.spec;
  std::optional<Recipe> recipe = LoadRecipe(reference, options, sources, findings);
  if (!recipe) return std::nullopt;
  if (recipe->spec->sha256 != record.spec_sha256) {
    findings.Add(diag::Code::kOutputDiffers, {},
                 fmt::format("spec '{}' has changed since: its hash is {}, the record says {}",
                             recipe->spec->file, recipe->spec->sha256, record.spec_sha256),
                 "name the spec of that time with --spec");
    return std::nullopt;
  }
  recipe->reference = record.spec;
  return recipe;
}

std::string_view TakeLine(std::string_view& rest) {
  const std::string_view line = rest.substr(0, rest.find('\n'));
  rest.remove_prefix(std::min(line.size() + 1, rest.size()));
  return line;
}

// True if the object's file (or its hash, if the file is gone) is the variant's.
bool IsSame(const Original& original, const Variant& variant, diag::Sources& sources,
            diag::Findings& findings) {
  std::error_code ignored;
  const std::filesystem::path& holder = original.archive.empty() ? original.file : original.archive;
  if (original.from_manifest && !std::filesystem::exists(holder, ignored)) {
    if (original.record.sha256 == variant.record.sha256) return true;
    findings.Add(diag::Code::kOutputDiffers, {},
                 fmt::format("made again, '{}' has the hash {}; the record says {}",
                             original.record.file, variant.record.sha256, original.record.sha256));
    return false;
  }
  std::optional<std::string> present =
      original.archive.empty()
          ? output::ReadFile(original.file, findings)
          : output::ReadMember(original.archive, original.file.string(), findings);
  if (!present) return false;
  if (*present == variant.document.text) return true;
  std::string_view rest = *present;
  std::string_view expected = variant.document.text;
  std::uint32_t number = 1;
  for (; !rest.empty() || !expected.empty(); ++number) {
    const std::string_view line = TakeLine(rest);
    const std::string_view expected_line = TakeLine(expected);
    if (line == expected_line) continue;
    expected = expected_line;
    break;
  }
  const std::string message =
      fmt::format("line {} differs from the object made again: '{}'", number,
                  expected.substr(std::min(expected.find_first_not_of(' '), expected.size())));
  const diag::SourceMark mark{sources.Add(original.file.string(), *std::move(present)), number, 1};
  findings.Add(diag::Code::kOutputDiffers, mark, message);
  return false;
}

// A failed variant is not there to compare with; its findings are.
bool ReplayFailure(const Original& original, const Variant& variant, diag::Findings& findings) {
  if (variant.ok()) {
    findings.Add(diag::Code::kOutputDiffers, {},
                 fmt::format("variant {} is recorded as {}, but can be made", original.record.index,
                             original.record.status));
  }
  findings.Append(variant.findings);
  return false;
}

bool MakeAgain(const Original& original, const Recipe& recipe, Options options,
               diag::Sources& sources, diag::Findings& findings) {
  Variant variant;
  const bool failed = original.from_manifest && original.record.status != "ok";
  // A file that is there was found valid, or not asked about: MuJoCo's verdict
  // has no part in its bytes.
  const Validation validation = options.validation;
  if (!failed) options.validation = Validation::kNone;
  Generator generator(recipe, sources, options);
  generator.Make(original.record.index, variant);
  if (failed) return ReplayFailure(original, variant, findings);
  diag::Findings differences;
  if (variant.ok() && IsSame(original, variant, sources, differences)) return true;
  if (!original.from_manifest) {
    // The comment does not say which draw it was, if earlier ones were invalid.
    options.resample = true;
    options.validation = validation;
    Variant resampled;
    Generator resampler(recipe, sources, options);
    resampler.Make(original.record.index, resampled);
    diag::Findings ignored;
    if (resampled.ok() && resampled.record.attempt != variant.record.attempt &&
        IsSame(original, resampled, sources, ignored)) {
      return true;
    }
  }
  findings.Append(variant.findings);
  findings.Append(std::move(differences));
  return false;
}

}  // namespace

bool Replay(const ReplayRequest& request, diag::Sources& sources, diag::Findings& findings) {
  const auto record_place = SplitIndex(request.what);
  const std::filesystem::path file = record_place ? record_place->first : request.what;
  const std::optional<Original> original =
      record_place ? FromManifest(file, record_place->second, findings) : FromFile(file, findings);
  if (!original) return false;
  const std::optional<mjcf::Target> target = mjcf::FindTarget(original->record.target);
  if (!target) {
    AddBadManifest(findings, fmt::format("'{}' was made for target '{}', which is not known here",
                                         request.what, original->record.target));
    return false;
  }
  const std::string& sampler = original->record.sampler;
  const std::optional<sample::Method> method =
      sampler.empty() ? sample::Method::kRandom : sample::FindMethod(sampler);
  if (!method) {
    AddBadManifest(findings, fmt::format("'{}' was made with sampler '{}', which is not known here",
                                         request.what, sampler));
    return false;
  }
  const std::optional<Recipe> recipe =
      LoadOriginalRecipe(*original, request, file.parent_path(), sources, findings);
  if (!recipe) return false;
  Options options;
  options.seed = original->record.seed;
  options.target = *target;
  options.name = original->record.name;
  options.attempt = original->record.attempt;
  options.sampler = *method;
  options.batch = original->record.batch;
  options.validation = FindValidation(original->record.validate).value_or(Validation::kLoad);
  return MakeAgain(*original, *recipe, options, sources, findings);
}

}  // namespace mjforge::forge
