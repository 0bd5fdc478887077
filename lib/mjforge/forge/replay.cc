// Replay: regenerates a recorded variant and compares its bytes.

#include <fmt/format.h>

#include <algorithm>

#include "mjforge/bytes/bytes.h"
#include "mjforge/forge/forge.h"

namespace mjforge::forge {
namespace {

// The variant to regenerate and compare, as recorded in a manifest or a generated file.
struct Original {
  manifest::Record record;        // only the known fields are set
  bool from_manifest = false;     // true: `attempt`, `status` and `sha256` are known
  std::filesystem::path file;     // object's file; empty: none was written
  std::filesystem::path archive;  // contains the file; empty: the file is in a folder
  std::filesystem::path folder;   // base of the relative path record.spec_file
};

// Splits "out/manifest.jsonl:42" into file and index; returns nullopt if there is no index.
std::optional<std::pair<std::string, std::uint64_t>> SplitIndex(const std::string& what) {
  const std::size_t colon = what.rfind(':');
  if (colon == std::string::npos) return std::nullopt;
  const std::optional<std::uint64_t> index = output::ReadIndex(what.substr(colon + 1));
  if (!index) return std::nullopt;
  return std::pair(what.substr(0, colon), *index);
}

// Returns the original of a record. `batch`: see output::ManifestOf(); another archive may belong
// to a series.
std::optional<Original> FromManifest(const std::string& batch, std::uint64_t index,
                                     diag::Sources& sources, diag::Findings& findings) {
  const std::filesystem::path file = output::ManifestOf(batch).value_or(batch);
  if (file != batch && !bytes::IsFolder(batch) && !bytes::Exists(file)) {
    findings.AddCannotRead(batch, "it has no manifest of its own; name that of its series");
    return std::nullopt;
  }
  std::optional<manifest::Record> record = manifest::FindRecord(file, index, sources, findings);
  if (!record) return std::nullopt;
  Original original;
  original.from_manifest = true;
  original.folder = file.parent_path();
  if (!record->archive.empty()) {
    original.file = record->file;
    original.archive = file.parent_path() / record->archive;
  } else if (!record->file.empty()) {
    original.file = file.parent_path() / record->file;
  }
  original.record = *std::move(record);
  return original;
}

// Finds the spec's file through a manifest, because the comment in an object's file has the name of
// the spec without its folder. The manifest is beside the object's file or, in a large batch or for
// an object of a scene, up to three folders up.
void FindSpecFile(Original& original) {
  for (const std::filesystem::path& folder :
       {original.folder, original.folder / "..", original.folder / "../..",
        original.folder / "../../.."}) {
    std::error_code error;
    for (const std::filesystem::path& file : output::EntriesOf(folder, error)) {
      diag::Sources sources;
      diag::Findings ignored;
      if (file.filename().string().find(".jsonl") == std::string::npos) continue;
      auto records = manifest::RecordReader::Open(file, sources, ignored);
      manifest::Record first;
      if (!records || records->Next(first) != manifest::RecordReader::Outcome::kRecord) continue;
      if (first.spec_file.empty() || first.spec_sha256 != original.record.spec_sha256) continue;
      original.record.spec_file = first.spec_file;
      original.folder = folder;
      return;
    }
  }
}

std::optional<Original> FromFile(const std::filesystem::path& file, diag::Findings& findings) {
  const std::optional<std::string> text = output::ReadFile(file, bytes::kMaxMjcf, findings);
  if (!text) return std::nullopt;
  const std::optional<mjcf::Provenance> provenance = mjcf::ReadProvenance(*text);
  if (!provenance) {
    findings.Add(diag::Code::kOutputBadManifest, {},
                 fmt::format("'{}' does not start with mjforge's comment", file.string()),
                 file.string().ends_with(output::kPlacementEnding)
                     ? "replay MANIFEST:INDEX, or the file of an object"
                     : "only files that mjforge wrote can be replayed");
    return std::nullopt;
  }
  Original original;
  original.file = file;
  original.folder = file.parent_path();
  static_cast<mjcf::Provenance&>(original.record) = *provenance;
  FindSpecFile(original);
  return original;
}

// Returns the regenerated text of the recorded file: the file of the variant or, if the record has
// a `part`, of one object of its scene.
std::string_view TextOf(const Original& original, const Variant& variant) {
  const mjcf::MjcfDocument& output = variant.output();
  if (original.record.part.empty()) return output.text;
  const auto found = std::ranges::find_if(output.assets, [&](const bytes::Asset& asset) {
    return asset.made && mjcf::ReadProvenance(*asset.made).value_or(mjcf::Provenance()).part ==
                             original.record.part;
  });
  return found == output.assets.end() ? std::string_view() : std::string_view(*found->made);
}

// Returns true if the recorded file equals the regenerated file. Compares only their hashes if a
// manifest lists the file but the file is missing. Adds a finding if they differ.
bool HasSameText(const Original& original, const Variant& variant, diag::Sources& sources,
                 diag::Findings& findings) {
  const std::filesystem::path& holder = original.archive.empty() ? original.file : original.archive;
  // Compares hashes if there is no file. A family (.npz), for example, contains the numbers of its
  // variants, but not their files.
  const bool has_no_file = original.file.empty() || !bytes::Exists(holder);
  if (original.from_manifest && has_no_file) {
    if (original.record.sha256 == variant.record.sha256) return true;
    findings.Add(diag::Code::kOutputDiffers, {},
                 fmt::format("the regenerated '{}' has the hash {}; the record says {}",
                             variant.record.file, variant.record.sha256, original.record.sha256));
    return false;
  }
  std::optional<std::string> recorded =
      original.archive.empty()
          ? output::ReadFile(original.file, bytes::kMaxMjcf, findings)
          : output::ReadMember(original.archive, original.file.string(), findings);
  if (!recorded) return false;
  const std::string_view expected = TextOf(original, variant);
  if (*recorded == expected) return true;
  const auto [at, same] = std::ranges::mismatch(*recorded, expected);
  const auto number = static_cast<std::uint32_t>(1 + std::count(recorded->begin(), at, '\n'));
  const auto start = static_cast<std::size_t>(same - expected.begin());
  std::string_view line = expected.substr(start == 0 ? 0 : expected.rfind('\n', start - 1) + 1);
  line = line.substr(0, line.find('\n'));
  const std::string message =
      fmt::format("line {} differs from the regenerated object: '{}'", number,
                  line.substr(std::min(line.find_first_not_of(' '), line.size())));
  const diag::SourceMark mark{sources.Add(original.file.string(), *std::move(recorded)), number, 1};
  findings.Add(diag::Code::kOutputDiffers, mark, message);
  return false;
}

// Returns true if all assets of the record have the same hashes as those of the regenerated object;
// otherwise adds findings.
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

// Adds the findings of a variant that is recorded as failed. Such a variant has no file to compare
// with. Returns false.
bool ReplayFailure(const Original& original, const Variant& variant, diag::Findings& findings) {
  if (variant.ok()) {
    findings.Add(diag::Code::kOutputDiffers, {},
                 fmt::format("variant {} is recorded as {}, but can be made", original.record.index,
                             NameOf(original.record.status)));
  }
  findings.Append(variant.findings);
  return false;
}

// Warns if another release of MuJoCo settled the piles, because its simulation gives other poses.
void WarnOfOtherMujoco(const manifest::Record& record, diag::Findings& findings) {
  if (record.pile_mujoco.empty() || record.pile_mujoco == validate::MujocoVersion()) return;
  findings.Warn(diag::Code::kMujocoOlder, {},
                fmt::format("the piles of variant {} were settled by MuJoCo {}, and this is {}",
                            record.index, record.pile_mujoco, validate::MujocoVersion()),
                "replay it with the same release");
}

bool Regenerate(const Original& original, const Recipe& recipe, Options options,
                diag::Sources& sources, diag::Findings& findings) {
  Variant variant;
  const bool failed = original.from_manifest && original.record.status != manifest::Status::kOk;
  // Skips validation, because it does not affect the bytes, and the recorded variant either passed
  // validation or was not validated.
  if (!failed) options.validation = Validation::kNone;
  WarnOfOtherMujoco(original.record, findings);
  Generator generator(recipe, sources, options);
  generator.Make(original.record.index, variant);
  if (failed) return ReplayFailure(original, variant, findings);
  diag::Findings differences;
  if (variant.ok() && HasSameText(original, variant, sources, differences) &&
      HasSameAssets(original, variant, differences)) {
    return true;
  }
  // Tries each kind of validation, because the comment in a file contains neither the attempt nor
  // the kind of validation that rejected earlier attempts.
  if (!original.from_manifest) {
    for (const Validation validation : {Validation::kLoad, Validation::kPhysics}) {
      options.on_invalid = OnInvalid::kResample;
      options.validation = validation;
      Variant resampled;
      Generator(recipe, sources, options).Make(original.record.index, resampled);
      diag::Findings ignored;
      if (resampled.ok() && resampled.record.attempt != variant.record.attempt &&
          HasSameText(original, resampled, sources, ignored)) {
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
      LoadRecordedRecipe(original->record, request.spec, original->folder, sources, findings);
  if (!recipe) return false;
  return Regenerate(*original, *recipe, *options, sources, findings);
}

}  // namespace mjforge::forge
