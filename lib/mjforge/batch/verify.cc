// Verifying finished batches: comparison of all their files with seals and records.

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>

#include "mjforge/batch/batch.h"
#include "mjforge/batch/output_checker.h"

namespace mjforge::batch {
namespace {

constexpr std::string_view kSealEnding = ".seal.json";
constexpr std::string_view kManifestEnding = ".jsonl";
constexpr std::string_view kCompressedEnding = ".zst";
constexpr std::string_view kPartEnding = ".part";

// Returns true for the name of a manifest of a whole batch; false for the manifest of a shard.
bool IsWholeManifest(std::string_view name) {
  return name.find("manifest.jsonl") != name.npos && output::IsManifestName(name);
}

class Verification {
 public:
  Verification(diag::Sources& sources, diag::Findings& findings)
      : sources_(sources), findings_(findings) {}

  VerifyResult operator()(const std::filesystem::path& what) {
    const std::string name = what.filename().string();
    if (bytes::IsFolder(what)) {
      CheckFolder(what);
    } else if (name.ends_with(kSealEnding)) {
      CheckBatch(ReadSeal(what));
    } else if (output::IsManifestName(name)) {
      CheckBatch(SealBeside(what));
    } else if (const auto series = SeriesOf(what)) {
      CheckSeries(*series);
    } else {
      CheckArchive(what);
    }
    return result_;
  }

 private:
  /// A seal, if it can be read, and the manifest beside it.
  struct SealedManifest {
    std::filesystem::path file;
    std::optional<manifest::Seal> seal = {};
    std::string why_not = {};  // the reason if there is no seal
  };

  /// The shards of one batch that were checked, and the seal and the first record of the first
  /// ones.
  struct Shards {
    std::set<std::uint64_t> present;
    std::optional<manifest::Seal> seal = {};
    std::optional<manifest::Record> record = {};
  };

  static SealedManifest SealBeside(const std::filesystem::path& manifest) {
    SealedManifest sealed{manifest};
    sealed.seal = manifest::ReadSealBeside(manifest, sealed.why_not);
    return sealed;
  }

  /// Reads a seal, which names its manifest. If the seal cannot be read, the manifest is the
  /// compressed one if this file exists, otherwise the uncompressed one.
  static SealedManifest ReadSeal(std::filesystem::path seal) {
    SealedManifest sealed = SealBeside(seal.replace_extension().replace_extension(kManifestEnding));
    std::filesystem::path compressed = sealed.file;
    compressed += kCompressedEnding;
    const bool is_compressed = sealed.seal ? sealed.seal->manifest.file == compressed.filename()
                                           : bytes::Exists(compressed);
    if (is_compressed) sealed.file = compressed;
    return sealed;
  }

  std::vector<std::filesystem::path> SealsIn(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> seals;
    for (const std::string& name : NamesIn(folder, findings_)) {
      if (name.ends_with(kSealEnding)) seals.push_back(folder / name);
    }
    return seals;
  }

  void CheckFolder(const std::filesystem::path& folder) {
    bool is_empty = true;
    for (const std::string& name : NamesIn(folder, findings_)) {
      if (name.ends_with(kPartEnding) &&
          IsWholeManifest(std::string_view(name).substr(0, name.size() - kPartEnding.size()))) {
        ReportMissing(fmt::format("'{}' is of a batch that is not done", (folder / name).string()),
                      "the command that began it goes on with --resume");
      } else if (name.ends_with(kSealEnding)) {
        CheckUnlessMerged(ReadSeal(folder / name));
      } else if (IsWholeManifest(name) && !bytes::Exists(manifest::SealPathOf(folder / name))) {
        CheckBatch(SealBeside(folder / name));  // reports that the seal is missing
      } else {
        continue;
      }
      is_empty = false;
    }
    if (is_empty && findings_.empty())
      ReportMissing(fmt::format("'{}' has no manifest", folder.string()), {});
    ReportMissingShards();
  }

  void CheckBatch(const SealedManifest& sealed) {
    const auto& [manifest, seal, why_not] = sealed;
    if (!seal) {
      ReportMissing(fmt::format("'{}' cannot be verified: '{}': {}", manifest.string(),
                                manifest::SealPathOf(manifest).string(), why_not),
                    "run the command that made it again with --resume");
      return;
    }
    if (seal->manifest.file != manifest.filename()) {
      ReportMissing(
          fmt::format("'{}' is not the manifest of '{}', which names '{}'", manifest.string(),
                      manifest::SealPathOf(manifest).string(), seal->manifest.file),
          "it is left over from another batch in this place");
      return;
    }
    const output::Shard shard{seal->shard, seal->shards};
    if (!shard.IsWhole()) {
      Shards& shards = shards_[WholeOf(manifest, shard)][shard.count];
      shards.present.insert(shard.index);
      CheckIsOfOneBatch(manifest, *seal, shards);
    }
    const std::filesystem::path folder = manifest.parent_path();
    for (const manifest::SealedFile& archive : seal->archives) Check(folder, archive);
    if (!Check(folder, seal->manifest)) return;
    result_.variants += seal->records;
    if (seal->output.empty()) CheckObjects(manifest);
  }

  // Checks the batch or shard of a manifest, unless the shard was merged into a manifest, which is
  // checked, too, and has the shard's records.
  void CheckUnlessMerged(const SealedManifest& sealed) {
    if (const auto& seal = sealed.seal; seal && seal->shards > 1) {
      std::string ignored;
      const auto whole =
          manifest::ReadSealBeside(WholeOf(sealed.file, {seal->shard, seal->shards}), ignored);
      if (whole && whole->shards == 1 && whole->spec == seal->spec &&
          DifferenceOfShards(*seal, *whole).empty()) {
        return;
      }
    }
    CheckBatch(sealed);
  }

  // Reports a shard that belongs to another batch than the shards that were checked before.
  void CheckIsOfOneBatch(const std::filesystem::path& manifest, const manifest::Seal& seal,
                         Shards& shards) {
    diag::Findings ignored;
    auto reader = manifest::RecordReader::Open(manifest, sources_, ignored);
    manifest::Record record;
    const bool has_record =
        reader && reader->Next(record) == manifest::RecordReader::Outcome::kRecord;
    std::string difference;
    if (shards.seal) difference = DifferenceOfShards(seal, *shards.seal);
    if (shards.record && has_record && difference.empty())
      difference = manifest::DifferenceOfBatch(record, *shards.record);
    if (!difference.empty())
      ReportOtherShard(fmt::format("'{}'", manifest.string()), difference, findings_);
    if (!shards.seal) shards.seal = seal;
    if (!shards.record && has_record) shards.record = record;
  }

  // Returns the path of the manifest into which `merge` joins this shard's manifest.
  static std::filesystem::path WholeOf(std::filesystem::path manifest, const output::Shard& shard) {
    std::string name = manifest.filename().string();
    const std::string suffix = shard.Suffix();
    if (const std::size_t at = name.rfind(suffix); at != name.npos) name.erase(at, suffix.size());
    return manifest.replace_filename(name);
  }

  // Reports the missing manifests of shards, for all checked batches that were not merged.
  void ReportMissingShards() {
    for (const auto& [whole, batches] : shards_) {
      for (const auto& [count, shards] : batches) ReportMissingShards(whole, count, shards.present);
    }
  }

  void ReportMissingShards(const std::filesystem::path& whole, std::uint64_t count,
                           const std::set<std::uint64_t>& present) {
    std::uint64_t missing = count - present.size();
    for (output::Shard shard{0, count}; missing > 0 && findings_.size() < kMaxFindings;
         ++shard.index) {
      if (present.contains(shard.index)) continue;
      std::string name = whole.filename().string();
      name.insert(name.rfind(kManifestEnding), shard.Suffix());
      ReportMissingShard(shard, whole.parent_path() / name, findings_);
      --missing;
    }
    result_.more_findings += missing;
  }

  bool Check(const std::filesystem::path& folder, const manifest::SealedFile& file) {
    return Count([&](diag::Findings& found) { return CheckSealed(folder, file, true, found); });
  }

  void CheckObjects(const std::filesystem::path& manifest) {
    using Outcome = manifest::RecordReader::Outcome;
    auto reader = manifest::RecordReader::Open(manifest, sources_, findings_);
    OutputChecker objects(manifest.parent_path(), true);
    manifest::Record record;
    while (reader && reader->Next(record) == Outcome::kRecord) {
      if (record.status == Status::kOk)
        Count([&](diag::Findings& found) { return objects.Check(record, found); });
    }
  }

  // Counts a file that `check` accepts; otherwise adds or counts the finding of `check`.
  template <typename CheckFile>
  bool Count(const CheckFile& check) {
    diag::Findings found;
    const bool is_good = check(found);
    if (is_good) {
      ++result_.files;
    } else if (findings_.size() < kMaxFindings) {
      findings_.Append(std::move(found));
    } else {
      ++result_.more_findings;
    }
    return is_good;
  }

  // Returns the destination that has this name, if it is a series of archives or of families;
  // otherwise nullopt.
  static std::optional<output::Destination> SeriesOf(const std::filesystem::path& what) {
    std::string ignored;
    std::optional<output::Destination> series = output::ParseDestination(what.string(), 1, ignored);
    if (!series || (series->kind != output::Destination::Kind::kArchives && !series->IsSplit()))
      return std::nullopt;
    return series;
  }

  // Checks the batches and shards whose seals name this series of archives or of families.
  void CheckSeries(const output::Destination& series) {
    bool is_sealed = false;
    for (const std::filesystem::path& file : SealsIn(series.Folder())) {
      const SealedManifest sealed = ReadSeal(file);
      if (!sealed.seal || sealed.seal->output != series.path.filename()) continue;
      CheckUnlessMerged(sealed);
      is_sealed = true;
    }
    if (!is_sealed && findings_.empty()) CheckUnsealed(series);
    ReportMissingShards();
  }

  // Reports that the seal of a series is missing, or is of a batch at another place.
  void CheckUnsealed(const output::Destination& series) {
    const SealedManifest sealed = SealBeside(series.Manifest({}));
    if (!sealed.seal) return CheckBatch(sealed);
    const std::string& output = sealed.seal->output;
    ReportMissing(
        fmt::format("'{}' is the manifest of '{}', not of '{}'", sealed.file.string(),
                    output.empty() ? "a folder" : output, series.path.filename().string()),
        "name what `mjforge generate` was told to make");
  }

  // Checks an archive by the seal of the batch that contains it.
  void CheckArchive(const std::filesystem::path& archive) {
    const std::filesystem::path folder = archive.parent_path();
    for (const std::filesystem::path& seal : SealsIn(folder)) {
      const SealedManifest sealed = ReadSeal(seal);
      if (!sealed.seal) continue;
      for (const manifest::SealedFile& file : sealed.seal->archives) {
        if (file.file != archive.filename()) continue;
        Check(folder, file);
        return;
      }
    }
    if (findings_.HasErrors()) return;
    if (!bytes::Exists(archive)) {
      findings_.AddCannotRead(archive.string(), "there is no such file");
      return;
    }
    ReportMissing(fmt::format("no seal beside '{}' is about it", archive.string()),
                  "run the command that made it again with --resume; other files have no seal");
  }

  void ReportMissing(std::string message, std::string hint) {
    findings_.Add(diag::Code::kBatchMissing, {}, std::move(message), std::move(hint));
  }

  diag::Sources& sources_;
  diag::Findings& findings_;
  VerifyResult result_;
  // By the manifest into which `merge` would join the shards, and by the number of shards.
  std::map<std::filesystem::path, std::map<std::uint64_t, Shards>> shards_;
};

}  // namespace

VerifyResult Verify(const std::filesystem::path& what, diag::Sources& sources,
                    diag::Findings& findings) {
  return Verification(sources, findings)(what);
}

}  // namespace mjforge::batch
