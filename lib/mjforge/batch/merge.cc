// Merging the manifests of shards: checks of completeness and origin, and the seal of the whole
// batch.

#include <fmt/format.h>

#include <map>

#include "mjforge/batch/batch.h"
#include "mjforge/batch/family_files.h"
#include "mjforge/batch/output_checker.h"
#include "mjforge/batch/sink.h"

namespace mjforge::batch {
namespace {

// Returns the shard in a manifest's name: 3 of 8 for "manifest-00003-of-00008.jsonl" if the merged
// manifest is "manifest.jsonl"; nullopt for other names.
std::optional<output::Shard> ShardOf(std::string_view name, std::string_view manifest) {
  constexpr std::string_view kOf = "-of-";
  const std::string_view ending = manifest.substr(manifest.rfind(".jsonl"));
  manifest.remove_suffix(ending.size());
  if (!name.starts_with(manifest) || !name.ends_with(ending)) return std::nullopt;
  name.remove_prefix(manifest.size());
  name.remove_suffix(ending.size());
  const std::size_t middle = name.find(kOf);
  if (!name.starts_with('-') || middle == name.npos) return std::nullopt;
  const auto index = output::ReadIndex(name.substr(1, middle - 1));
  const auto count = output::ReadIndex(name.substr(middle + kOf.size()));
  if (!index || !count) return std::nullopt;
  return output::Shard{*index, *count};
}

constexpr std::string_view kSameOptions =
    "were all shards made with the same -n, --first and --per-archive?";

class ShardMerger {
 public:
  ShardMerger(const output::Destination& destination, bool verify, diag::Sources& sources,
              diag::Findings& findings)
      : destination_(destination),
        verify_(verify),
        sources_(sources),
        findings_(findings),
        file_(destination.Manifest({})),
        objects_(destination.Folder(), verify) {}

  std::optional<std::uint64_t> operator()() {
    const std::optional<std::uint64_t> count = FindShards();
    if (!count || !CheckSeals(*count) || !MayReplaceManifest(file_, false, findings_) ||
        !MayReplaceManifest(output::PartFile::TemporaryNameOf(file_), false, findings_)) {
      return std::nullopt;
    }
    std::unique_ptr<output::PartFile> part = output::PartFile::Open(file_, findings_);
    output::RemoveAbandoned({manifest::SealPathOf(file_)});
    if (!part || !part->Truncate(0, findings_)) return std::nullopt;
    const bool is_complete = AppendAll(*count, *part);
    if (is_complete && Finish(*part)) return records_;
    if (!is_complete) part->Drop();
    for (const auto& npz : families_) npz->Drop();
    return std::nullopt;
  }

 private:
  bool is_family() const { return destination_.kind == output::Destination::Kind::kFamily; }

  // Merges the rows of all shards (the archives in their seals) into the whole batch's family
  // files.
  bool WriteFamily() {
    const auto rows = diag::Mapped<std::filesystem::path>(
        whole_.archives, [&](const auto& file) { return destination_.Folder() / file.file; });
    families_ =
        WriteFamilies(destination_, rows, *first_, {whole_.first, whole_.count}, false, findings_);
    whole_.archives.clear();
    for (const auto& npz : families_) {
      whole_.archives.push_back(
          {npz->final_path().filename().string(), {npz->size(), npz->checksum()}});
    }
    return !families_.empty();
  }

  // Returns the number of shards; nullopt, after adding findings, if a shard is missing.
  std::optional<std::uint64_t> FindShards() {
    std::map<std::uint64_t, std::set<std::uint64_t>> found;  // shard indices, by number of shards
    const std::string manifest = file_.filename().string();
    for (const std::string& name : NamesIn(destination_.Folder(), findings_)) {
      if (const auto shard = ShardOf(name, manifest)) found[shard->count].insert(shard->index);
    }
    if (findings_.HasErrors()) return std::nullopt;
    if (found.empty()) {
      ReportMissing(fmt::format("no shard of '{}' has a manifest", file_.string()),
                    "a shard's manifest gets its name when the shard is done");
      return std::nullopt;
    }
    if (found.size() > 1) {
      findings_.Add(diag::Code::kBatchDiffers, {},
                    fmt::format("there are batches of {} and of {} shards next to '{}'",
                                found.begin()->first, found.rbegin()->first, file_.string()),
                    "remove the manifests of the batch that you do not want");
      return std::nullopt;
    }
    const auto& [count, indices] = *found.begin();
    for (std::uint64_t i = 0; i < count && findings_.size() < kMaxFindings; ++i) {
      if (indices.contains(i)) continue;
      ReportMissingShard({i, count}, destination_.Manifest({i, count}), findings_);
    }
    if (findings_.HasErrors()) return std::nullopt;
    return count;
  }

  void ReportMissing(std::string message, std::string hint) {
    findings_.Add(diag::Code::kBatchMissing, {}, std::move(message), std::move(hint));
  }

  // Returns true if all shards match their seals and belong to one batch; otherwise adds findings.
  bool CheckSeals(std::uint64_t count) {
    for (std::uint64_t i = 0; i < count && findings_.size() < kMaxFindings; ++i) {
      const std::filesystem::path file = destination_.Manifest({i, count});
      std::string why_not;
      std::optional<manifest::Seal> seal = manifest::ReadSealBeside(file, why_not);
      if (!seal || seal->shard != i || seal->shards != count) {
        ReportMissing(fmt::format("shard {}/{} cannot be verified: '{}': {}", i, count,
                                  manifest::SealPathOf(file).string(),
                                  seal ? "it is another shard's" : why_not),
                      fmt::format("make it with --shard {}/{} --resume", i, count));
        continue;
      }
      if (i == 0) whole_ = *seal;
      if (const std::string difference = DifferenceOf(*seal); !difference.empty()) {
        ReportOtherShard(fmt::format("'{}'", file.string()), difference, findings_);
        continue;
      }
      CheckSealed(destination_.Folder(), seal->manifest, true, findings_);
      for (const manifest::SealedFile& archive : seal->archives) {
        CheckSealed(destination_.Folder(), archive, verify_ || is_family(), findings_);
        if (i > 0) whole_.archives.push_back(archive);
      }
    }
    return !findings_.HasErrors();
  }

  // Describes how a shard differs from the shards before it; returns an empty text, and adds the
  // shard's assets to `whole_`, if the shard belongs to the same batch.
  std::string DifferenceOf(const manifest::Seal& seal) {
    std::string difference = DifferenceOfShards(seal, whole_);
    if (!difference.empty()) return difference;
    for (const auto& [name, sha256] : seal.assets) {
      if (whole_.assets.emplace(name, sha256).first->second != sha256)
        return fmt::format("'{}' has other bytes", name);
    }
    return {};
  }

  // Appends the records of all shards, and writes the family.
  bool AppendAll(std::uint64_t count, output::PartFile& part) {
    for (std::uint64_t i = 0; i < count; ++i) {
      if (!Append(destination_.Manifest({i, count}), part)) return false;
    }
    if (is_family() && !WriteFamily()) return false;
    if (records_ == whole_.count) return !IsCompressed() || part.AppendSeekTable(findings_);
    ReportMissing(
        fmt::format("the shards have {} variants, and their batch {}", records_, whole_.count),
        std::string(kSameOptions));
    return false;
  }

  // Gives all files their final names, the manifest last.
  bool Finish(output::PartFile& part) {
    whole_.shard = 0;
    whole_.shards = 1;
    whole_.records = records_;
    whole_.manifest = {file_.filename().string(), {part.size(), part.checksum()}};
    const auto commit = [&](const auto& npz) {
      return npz->Commit(true, output::Durability::kBatch, findings_);
    };
    return std::ranges::all_of(families_, commit) &&
           output::WriteFile(manifest::SealPathOf(file_), manifest::SealText(whole_), true,
                             findings_, output::Durability::kBatch) &&
           part.Commit(true, output::Durability::kBatch, findings_);
  }

  bool Append(const std::filesystem::path& shard, output::PartFile& part) {
    using Outcome = manifest::RecordReader::Outcome;
    std::optional<manifest::RecordReader> reader =
        manifest::RecordReader::Open(shard, sources_, findings_);
    if (!reader) return false;
    manifest::Record record;
    Outcome outcome = reader->Next(record);
    for (; outcome == Outcome::kRecord; outcome = reader->Next(record)) {
      if (!Check(record, shard, reader->number())) return false;
    }
    if (outcome != Outcome::kEnd) return false;
    std::string why_not;
    const std::optional<std::uint64_t> count = BytesOfRecords(shard, why_not);
    if (count) return part.AppendFrom(shard, *count, findings_);
    findings_.AddCannotRead(shard.string(), why_not);
    return false;
  }

  bool IsCompressed() const { return destination_.format == output::ArchiveFormat::kTarZstd; }

  // Returns the size of a manifest without its seek table, in bytes.
  std::optional<std::uint64_t> BytesOfRecords(const std::filesystem::path& manifest,
                                              std::string& why_not) const {
    if (!IsCompressed()) {
      std::error_code error;
      const std::uint64_t size = std::filesystem::file_size(manifest, error);
      why_not = error.message();
      return error ? std::nullopt : std::optional(size);
    }
    const auto frames = bytes::FramesOf(manifest, why_not);
    if (!frames) return std::nullopt;
    return frames->empty() ? 0 : frames->back().end();
  }

  // Returns true if there is no manifest of the whole batch yet, or if its first record comes from
  // the same batch as a record of a shard. Otherwise adds a finding: a run without shards may have
  // replaced the files.
  bool IsOfFormer(const manifest::Record& record) {
    std::string why_not;
    std::string line;
    std::optional<bytes::LineReader> lines = bytes::LineReader::Open(file_, why_not);
    if (!lines || !lines->Next(line, why_not)) return true;
    const std::optional<manifest::Record> former = manifest::ReadRecord(line, why_not);
    const std::string difference =
        former ? manifest::DifferenceOfBatch(*former, record) : std::string();
    if (difference.empty()) return true;
    findings_.Add(
        diag::Code::kBatchDiffers, {},
        fmt::format("'{}' is not of the batch of its shards: {}", file_.string(), difference),
        "remove the manifests of the batch that you do not want");
    return false;
  }

  bool Check(const manifest::Record& record, const std::filesystem::path& shard,
             std::uint64_t number) {
    if (!first_) {
      first_ = record;
      if (!IsOfFormer(record)) return false;
    }
    const std::string difference = manifest::DifferenceOfBatch(record, *first_);
    if (!difference.empty()) {
      ReportOtherShard(fmt::format("line {} of '{}'", number, shard.string()), difference,
                       findings_);
      return false;
    }
    const std::uint64_t expected = whole_.first + records_;
    if (record.index != expected) {
      ReportMissing(
          fmt::format("line {} of '{}' has index {}; expected {}", number, shard.string(),
                      record.index, expected),
          fmt::format("{}: {}",
                      record.index < expected ? "a variant appears twice" : "variants are missing",
                      kSameOptions));
      return false;
    }
    ++records_;
    return record.status != Status::kOk || !record.archive.empty() ||
           objects_.Check(record, findings_);
  }

  const output::Destination& destination_;
  bool verify_;
  diag::Sources& sources_;
  diag::Findings& findings_;
  std::filesystem::path file_;
  OutputChecker objects_;
  manifest::Seal whole_;                                     // seal of the merged batch
  std::optional<manifest::Record> first_;                    // first record of shard 0
  std::vector<std::unique_ptr<output::PartFile>> families_;  // files that lack their final names
  std::uint64_t records_ = 0;
};

}  // namespace

std::optional<std::uint64_t> Merge(const output::Destination& destination, bool verify,
                                   diag::Sources& sources, diag::Findings& findings) {
  return ShardMerger(destination, verify, sources, findings)();
}

void RemoveMerged(const output::Destination& destination, const IndexRange& batch) {
  if (destination.kind == output::Destination::Kind::kFamily) return;
  const std::filesystem::path merged = destination.Manifest({});
  std::string why_not;
  const std::optional<manifest::Seal> seal = manifest::ReadSealBeside(merged, why_not);
  if (!seal || seal->first >= batch.first + batch.count || batch.first >= seal->first + seal->count)
    return;
  for (const auto& file : {merged, manifest::SealPathOf(merged)}) {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
  }
}

}  // namespace mjforge::batch
