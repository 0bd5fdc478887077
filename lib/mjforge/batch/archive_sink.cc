// The sink of archives: appends segments in order, closes archives, and resumes within one.

#include <algorithm>
#include <filesystem>
#include <set>
#include <span>

#include "mjforge/batch/journal.h"
#include "mjforge/batch/schedule.h"
#include "mjforge/batch/sealed_outputs.h"
#include "mjforge/batch/sink.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::batch {
namespace {

class ArchiveSink : public Sink {
 public:
  explicit ArchiveSink(const SinkOptions& options)
      : options_(options),
        request_(options.request),
        destination_(request_.destination),
        journal_(options) {}

  std::optional<ResumedVariants> Open(diag::Findings& findings) override {
    if (!folders_.Make(destination_.Folder(), findings) || !journal_.Open(findings))
      return std::nullopt;
    checkpoint_.next = options_.range.first;
    checkpoint_.archive = ArchiveOf(options_.range.first);
    const std::optional<ResumedVariants> resumed = FindResumable(findings);
    if (!resumed && !journal_.is_unfinished()) journal_.Drop();  // remove the files that Open made
    if (!resumed || (resumed->done() == 0 && !journal_.Start(checkpoint_, findings)))
      return std::nullopt;
    return resumed;
  }

  bool Take(ChunkResult& result, diag::Findings& findings) override {
    if (result.done < result.chunk.count) {
      // Ignore a partial segment: the bytes of the archive would depend on where the batch stopped.
      result.statuses.clear();
      result.variants.clear();
      result.findings.clear();
      return true;
    }
    if (result.chunk.archive != checkpoint_.archive && !CloseArchive(findings)) return false;
    if (!archive_ && !OpenArchive(0, findings)) return false;
    if (!AppendAssets(result, findings) || !archive_->Append(result.segment, findings) ||
        !journal_.AppendRecords(result.lines, findings)) {
      return false;
    }
    checkpoint_.next = result.chunk.end();
    checkpoint_.part = {archive_->size(), archive_->checksum()};
    return journal_.AddCheckpoint(checkpoint_, findings);
  }

  bool Finish(diag::Findings& findings) override {
    if (is_complete_) {
      journal_.Drop();
      return true;
    }
    const bool is_open = options_.range.count > 0 && checkpoint_.archive <= ArchiveOf(end() - 1);
    return (!is_open || CloseArchive(findings)) && journal_.Finish(findings);
  }

  void Drop() override {
    if (archive_) archive_->Drop();
    std::error_code ignored;
    for (const manifest::SealedFile& empty : journal_.closed())
      std::filesystem::remove(destination_.Folder() / empty.file, ignored);
    journal_.Drop();
  }

 private:
  // Returns the index after the last one.
  std::uint64_t end() const { return options_.range.first + options_.range.count; }

  // Returns the number of the archive that contains the variant.
  std::uint64_t ArchiveOf(std::uint64_t index) const {
    return destination_.per_archive == 0 ? 0
                                         : (index - options_.all.first) / destination_.per_archive;
  }

  std::optional<ResumedVariants> FindResumable(diag::Findings& findings) {
    if (!request_.resume) return ResumedVariants();
    if (journal_.is_unfinished()) return Continue(findings);
    return journal_.previous_seal() ? ContinueFinished(findings) : ResumedVariants();
  }

  // A sealed batch is either unchanged, with nothing to do, or made again from the start.
  std::optional<ResumedVariants> ContinueFinished(diag::Findings& findings) {
    const manifest::Seal& seal = *journal_.previous_seal();
    std::string why_not;
    const bool is_sound =
        bytes::IsSound(journal_.file(), seal.manifest.content, why_not) &&
        std::ranges::all_of(seal.archives, [&](const auto& file) { return IsIntact(file); });
    if (!is_sound) return ResumedVariants();
    const std::optional<ResumedVariants> resumed =
        ReadResumable(journal_.file(), options_, nullptr, findings);
    if (!resumed) return std::nullopt;
    is_complete_ = resumed->done() == options_.range.count;
    return is_complete_ ? resumed : ResumedVariants();
  }

  // Rolls back to the last checkpoint that matches manifest, archives and records.
  std::optional<ResumedVariants> Continue(diag::Findings& findings) {
    const std::vector<Checkpoint>& checkpoints = journal_.checkpoints();
    if (checkpoints.empty()) return ResumedVariants();
    const std::optional<ResumedVariants> whole = ReadResumable(
        journal_.part(), options_, nullptr, findings, journal_.CountBefore(checkpoints.back()));
    if (!whole) return std::nullopt;
    const std::optional<Checkpoint> checkpoint =
        LastValidCheckpoint(options_.range.first + whole->done());
    if (!checkpoint || checkpoint->next == options_.range.first) return ResumedVariants();
    // If the checkpoint is earlier, read the manifest again up to there, for the counts.
    const std::uint64_t count = journal_.CountBefore(*checkpoint);
    const std::optional<ResumedVariants> resumed =
        whole->done() == count ? whole
                               : ReadResumable(journal_.part(), options_, nullptr, findings, count);
    if (!journal_.RollBackTo(*checkpoint, findings)) return std::nullopt;
    checkpoint_ = *checkpoint;
    const bool is_open = checkpoint_.part.size == 0 || OpenArchive(checkpoint_.part.size, findings);
    return is_open ? resumed : std::nullopt;
  }

  std::optional<Checkpoint> LastValidCheckpoint(std::uint64_t most) const {
    const std::vector<manifest::SealedFile>& closed = journal_.closed();
    // If the part still exists, the archive was not renamed, and a file with its name is an older
    // one.
    const auto lost = std::ranges::find_if(closed, [&](const manifest::SealedFile& file) {
      return !IsIntact(file) || output::PartFile::Exists(destination_.Folder() / file.file);
    });
    const std::uint64_t archive =
        ArchiveOf(options_.range.first) + static_cast<std::uint64_t>(lost - closed.begin());
    std::vector<Checkpoint> candidates;  // checkpoints of the last archive that can be continued
    for (const Checkpoint& checkpoint : journal_.checkpoints()) {
      if (checkpoint.next > most || !CanContinueAt(checkpoint)) continue;
      if (checkpoint.archive > archive) break;
      if (!candidates.empty() && candidates.back().archive != checkpoint.archive)
        candidates.clear();
      candidates.push_back(checkpoint);
    }
    if (candidates.empty()) return std::nullopt;
    std::vector<bytes::Prefix> prefixes;
    prefixes.reserve(candidates.size());
    for (const Checkpoint& checkpoint : candidates) prefixes.push_back(checkpoint.part);
    // The first candidate is the start of the archive, which needs no check.
    const std::filesystem::path part =
        output::PartFile::TemporaryNameOf(destination_.Archive(candidates.front().archive));
    const std::size_t sound =
        bytes::CountSound(part, std::span<const bytes::Prefix>(prefixes).subspan(1));
    return candidates[sound];
  }

  // A batch that has become larger can continue only at the end of a full segment, and not after a
  // closed archive that must get more variants.
  bool CanContinueAt(const Checkpoint& checkpoint) const {
    if (checkpoint.next == end()) return true;
    const std::uint64_t made = checkpoint.next - options_.all.first;
    const std::uint64_t in_archive =
        destination_.per_archive == 0 ? made : made % destination_.per_archive;
    return in_archive % kSegmentVariants == 0 && checkpoint.archive <= ArchiveOf(checkpoint.next);
  }

  bool IsIntact(const manifest::SealedFile& archive) const {
    diag::Findings ignored;
    return CheckSealed(destination_.Folder(), archive, request_.verify, ignored);
  }

  bool OpenArchive(std::uint64_t bytes, diag::Findings& findings) {
    const std::filesystem::path file = destination_.Archive(checkpoint_.archive);
    std::error_code ignored;
    if (!request_.force &&
        std::filesystem::exists(std::filesystem::symlink_status(file, ignored)) &&
        !journal_.HasMadeArchive(file.filename().string()) && !output::IsObjectArchive(file)) {
      output::AddForeignFile(file, findings);
      return false;
    }
    archive_ = output::PartFile::Open(file, findings);
    return archive_ && archive_->Truncate(bytes, findings);
  }

  bool CloseArchive(diag::Findings& findings) {
    if (!archive_ && !OpenArchive(0, findings)) return false;
    if (!archive_->Append(output::ArchiveEnd(destination_.format), findings)) return false;
    const std::string name = destination_.Archive(checkpoint_.archive).filename().string();
    ++checkpoint_.archive;
    checkpoint_.part = {};
    const bool closed = journal_.AddClosedArchive({name, {archive_->size(), archive_->checksum()}},
                                                  checkpoint_, findings) &&
                        archive_->Commit(request_.if_changed, request_.durability, findings);
    if (closed) archive_.reset();
    return closed;
  }

  // Appends the assets that the archive does not have yet, before the first object that refers to
  // them.
  bool AppendAssets(const ChunkResult& result, diag::Findings& findings) {
    for (const HashedAsset& asset : result.assets) {
      if (journal_.HasAsset(asset)) continue;
      if (!journal_.AddAsset(asset, findings)) return false;
      const auto bytes = output::ReadAsset(asset.source, asset.sha256, findings);
      output::Segment segment(destination_.format);
      if (!bytes || !segment.Add(asset.name, *bytes, findings) ||
          !archive_->Append(segment.Bytes(), findings)) {
        return false;
      }
    }
    return true;
  }

  SinkOptions options_;
  const Request& request_;
  const output::Destination& destination_;
  output::MadeFolders folders_;  // declared before the journal, so that it is destroyed later
  Journal journal_;
  std::unique_ptr<output::PartFile> archive_;
  Checkpoint checkpoint_;
  bool is_complete_ = false;  // an earlier run finished the batch
};

}  // namespace

std::unique_ptr<Sink> MakeArchiveSink(const SinkOptions& options) {
  return std::make_unique<ArchiveSink>(options);
}

}  // namespace mjforge::batch
