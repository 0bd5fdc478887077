#include <fmt/format.h>

#include <algorithm>

#include "mjforge/bytes/bytes.h"
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

// "out/manifest.jsonl:42" -> the file and 42; nothing if it ends otherwise.
std::optional<std::pair<std::string, std::uint64_t>> SplitIndex(const std::string& what) {
  const std::size_t colon = what.rfind(':');
  if (colon == std::string::npos) return std::nullopt;
  const std::optional<std::uint64_t> index = output::ReadIndex(what.substr(colon + 1));
  if (!index) return std::nullopt;
  return std::pair(what.substr(0, colon), *index);
}

std::optional<Original> FromManifest(const std::filesystem::path& file, std::uint64_t index,
                                     diag::Sources& sources, diag::Findings& findings) {
  using Outcome = manifest::RecordReader::Outcome;
  std::optional<manifest::RecordReader> lines =
      manifest::RecordReader::Open(file, sources, findings);
  if (!lines) return std::nullopt;
  Original original;
  original.from_manifest = true;
  Outcome outcome = lines->Next(original.record);
  for (; outcome == Outcome::kRecord; outcome = lines->Next(original.record)) {
    const manifest::Record& known = original.record;
    if (known.index != index) continue;
    if (!known.archive.empty()) {
      original.file = known.file;
      original.archive = file.parent_path() / known.archive;
    } else if (!known.file.empty()) {
      original.file = file.parent_path() / known.file;
    }
    return original;
  }
  if (outcome == Outcome::kEnd) {
    findings.Add(diag::Code::kOutputBadManifest, {},
                 fmt::format("'{}' has no record with index {}", file.string(), index));
  }
  return std::nullopt;
}

std::optional<Original> FromFile(const std::filesystem::path& file, diag::Findings& findings) {
  const std::optional<std::string> text = output::ReadFile(file, bytes::kMaxMjcf, findings);
  if (!text) return std::nullopt;
  const std::optional<mjcf::Provenance> provenance = mjcf::ReadProvenance(*text);
  if (!provenance) {
    findings.Add(diag::Code::kOutputBadManifest, {},
                 fmt::format("'{}' does not start with mjforge's comment", file.string()),
                 "only files that mjforge wrote can be replayed");
    return std::nullopt;
  }
  Original original;
  original.file = file;
  static_cast<mjcf::Provenance&>(original.record) = *provenance;
  return original;
}

// True if the object's file (or its hash, if the file is gone) is the variant's.
bool IsSame(const Original& original, const Variant& variant, diag::Sources& sources,
            diag::Findings& findings) {
  std::error_code ignored;
  const std::filesystem::path& holder = original.archive.empty() ? original.file : original.archive;
  if (original.from_manifest && !std::filesystem::exists(holder, ignored)) {
    if (original.record.sha256 == variant.record.sha256) return true;
    findings.Add(diag::Code::kOutputDiffers, {},
                 fmt::format("the regenerated '{}' has the hash {}; the record says {}",
                             original.record.file, variant.record.sha256, original.record.sha256));
    return false;
  }
  std::optional<std::string> present =
      original.archive.empty()
          ? output::ReadFile(original.file, bytes::kMaxMjcf, findings)
          : output::ReadMember(original.archive, original.file.string(), findings);
  if (!present) return false;
  if (*present == variant.document.text) return true;
  const std::string_view expected = variant.document.text;
  const auto [at, same] = std::ranges::mismatch(*present, expected);
  const auto number = static_cast<std::uint32_t>(1 + std::count(present->begin(), at, '\n'));
  const auto start = static_cast<std::size_t>(same - expected.begin());
  std::string_view line = expected.substr(start == 0 ? 0 : expected.rfind('\n', start - 1) + 1);
  line = line.substr(0, line.find('\n'));
  const std::string message =
      fmt::format("line {} differs from the regenerated object: '{}'", number,
                  line.substr(std::min(line.find_first_not_of(' '), line.size())));
  const diag::SourceMark mark{sources.Add(original.file.string(), *std::move(present)), number, 1};
  findings.Add(diag::Code::kOutputDiffers, mark, message);
  return false;
}

// True if what the object refers to is as the record says.
bool HasSameAssets(const Original& original, const Variant& variant, diag::Findings& findings) {
  bool same = true;
  for (const auto& asset : original.record.assets) {
    if (std::ranges::find(variant.record.assets, asset) != variant.record.assets.end()) continue;
    findings.Add(diag::Code::kOutputDiffers, {},
                 fmt::format("'{}' is not the file that the object was made with", asset.first),
                 fmt::format("its SHA-256 was {}", asset.second));
    same = false;
  }
  return same;
}

// A failed variant is not there to compare with; its findings are.
bool ReplayFailure(const Original& original, const Variant& variant, diag::Findings& findings) {
  if (variant.ok()) {
    findings.Add(diag::Code::kOutputDiffers, {},
                 fmt::format("variant {} is recorded as {}, but can be made", original.record.index,
                             NameOf(original.record.status)));
  }
  findings.Append(variant.findings);
  return false;
}

bool MakeAgain(const Original& original, const Recipe& recipe, Options options,
               diag::Sources& sources, diag::Findings& findings) {
  Variant variant;
  const bool failed = original.from_manifest && original.record.status != manifest::Status::kOk;
  // A file that is there was found valid, or not asked about: MuJoCo's verdict
  // has no part in its bytes.
  if (!failed) options.validation = Validation::kNone;
  Generator generator(recipe, sources, options);
  generator.Make(original.record.index, variant);
  if (failed) return ReplayFailure(original, variant, findings);
  diag::Findings differences;
  if (variant.ok() && IsSame(original, variant, sources, differences) &&
      HasSameAssets(original, variant, differences)) {
    return true;
  }
  // The comment does not say which draw it was, if earlier ones were invalid, nor
  // what was asked of them.
  if (!original.from_manifest) {
    for (const Validation validation : {Validation::kLoad, Validation::kPhysics}) {
      options.on_invalid = OnInvalid::kResample;
      options.validation = validation;
      Variant resampled;
      Generator(recipe, sources, options).Make(original.record.index, resampled);
      diag::Findings ignored;
      if (resampled.ok() && resampled.record.attempt != variant.record.attempt &&
          IsSame(original, resampled, sources, ignored)) {
        return true;
      }
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
      record_place ? FromManifest(file, record_place->second, sources, findings)
                   : FromFile(file, findings);
  if (!original) return false;
  const std::optional<Options> options = RecordedOptions(original->record, request.what, findings);
  if (!options) return false;
  const std::optional<Recipe> recipe =
      LoadRecordedRecipe(original->record, request.spec, file.parent_path(), sources, findings);
  if (!recipe) return false;
  return MakeAgain(*original, *recipe, *options, sources, findings);
}

}  // namespace mjforge::forge
