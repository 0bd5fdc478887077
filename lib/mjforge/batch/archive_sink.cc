// Sink that writes archives: appends segments in order, closes archives, and resumes unfinished
// archives.

#include "mjforge/batch/archive_sink.h"

#include <algorithm>
#include <set>
#include <span>

#include "mjforge/batch/output_checker.h"
#include "mjforge/batch/schedule.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::batch {

bool ArchiveSink::Take(ChunkResult& result, diag::Findings& findings) {
  if (result.done < result.chunk.count) {
    // The worker stopped or failed within its part of the archive. Discards its finished variants,
    // too, because the bytes of the archive would otherwise depend on where the batch stopped.
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

bool ArchiveSink::Finish(diag::Findings& findings) {
  if (is_complete_) {
    journal_.Drop();
    return true;
  }
  const bool is_open = options_.range.count > 0 && checkpoint_.archive <= ArchiveOf(end() - 1);
  return (!is_open || CloseArchive(findings)) && journal_.Finish(findings);
}

void ArchiveSink::Drop(bool) {
  if (archive_) archive_->Drop();
  std::error_code ignored;
  for (const manifest::SealedFile& empty : journal_.closed_archives())
    std::filesystem::remove(destination_.Folder() / empty.file, ignored);
  journal_.Drop(journal_.closed_archives().empty());
}

// Returns the number of the archive that contains the variant.
std::uint64_t ArchiveSink::ArchiveOf(std::uint64_t index) const {
  return destination_.per_archive == 0 ? 0
                                       : (index - options_.all.first) / destination_.per_archive;
}

std::optional<ResumedVariants> ArchiveSink::Continue(diag::Findings& findings) {
  if (journal_.is_unfinished()) return ContinueUnfinished(findings);
  return journal_.previous_seal() ? ContinueFinished(findings) : ResumedVariants();
}

// Returns all variants of the earlier, finished batch if its files are unchanged and it has all
// variants of this batch. Otherwise returns no variants, so that the batch is made again from the
// start. Returns nullopt, after adding a finding, if the records are not those of this batch.
std::optional<ResumedVariants> ArchiveSink::ContinueFinished(diag::Findings& findings) {
  const manifest::Seal& seal = *journal_.previous_seal();
  const bool is_sound =
      bytes::IsSound(journal_.file(), seal.manifest.content) &&
      std::ranges::all_of(seal.archives, [&](const auto& file) { return IsIntact(file); });
  if (!is_sound) return ResumedVariants();
  const std::optional<ResumedVariants> resumed =
      ReadResumable(journal_.file(), options_, nullptr, findings);
  if (!resumed) return std::nullopt;
  is_complete_ = resumed->done() == options_.range.count;
  return is_complete_ ? resumed : ResumedVariants();
}

// Rolls the outputs back to the last checkpoint of the journal that matches the manifest, the
// archives and the records. Returns the variants before this checkpoint.
std::optional<ResumedVariants> ArchiveSink::ContinueUnfinished(diag::Findings& findings) {
  const std::vector<Checkpoint>& checkpoints = journal_.checkpoints();
  if (checkpoints.empty()) return ResumedVariants();
  const std::optional<ResumedVariants> whole = ReadResumable(
      journal_.part(), options_, nullptr, findings, journal_.CountBefore(checkpoints.back()));
  if (!whole) return std::nullopt;
  const std::optional<Checkpoint> checkpoint =
      LastValidCheckpoint(options_.range.first + whole->done());
  if (!checkpoint || checkpoint->next == options_.range.first) return ResumedVariants();
  // Counts only the records before the checkpoint if the manifest has records after it.
  const std::uint64_t count = journal_.CountBefore(*checkpoint);
  const std::optional<ResumedVariants> resumed =
      whole->done() == count ? whole
                             : ReadResumable(journal_.part(), options_, nullptr, findings, count);
  if (!journal_.RollBackTo(*checkpoint, findings)) return std::nullopt;
  checkpoint_ = *checkpoint;
  const bool is_open = checkpoint_.part.size == 0 || OpenArchive(checkpoint_.part.size, findings);
  return is_open ? resumed : std::nullopt;
}

std::optional<Checkpoint> ArchiveSink::LastValidCheckpoint(std::uint64_t most) const {
  const std::vector<manifest::SealedFile>& closed = journal_.closed_archives();
  // A partial file that still exists was never renamed, so the file with its final name comes from
  // an earlier batch.
  const auto lost = std::ranges::find_if(closed, [&](const manifest::SealedFile& file) {
    return !IsIntact(file) || output::PartFile::Exists(destination_.Folder() / file.file);
  });
  const std::uint64_t archive =
      ArchiveOf(options_.range.first) +
      CountClosed(static_cast<std::uint64_t>(lost - closed.begin()), closed.size());
  std::vector<Checkpoint> candidates;  // usable checkpoints of the last archive that has any
  for (const Checkpoint& checkpoint : journal_.checkpoints()) {
    if (checkpoint.next > most || !CanContinueAt(checkpoint)) continue;
    if (checkpoint.archive > archive) break;
    if (!candidates.empty() && candidates.back().archive != checkpoint.archive) candidates.clear();
    candidates.push_back(checkpoint);
  }
  if (candidates.empty()) return std::nullopt;
  // The first candidate needs no check, because it is the start of the archive.
  const auto prefixes =
      diag::Mapped<bytes::Fingerprint>(std::span(candidates).subspan(1), &Checkpoint::part);
  const std::filesystem::path part =
      output::PartFile::TemporaryNameOf(FileOf(candidates.front().archive));
  return candidates[bytes::CountSound(part, prefixes)];
}

// Returns true if the batch can continue at the checkpoint. A batch that has become larger cannot
// continue within a segment, or after a closed archive that must get more variants.
bool ArchiveSink::CanContinueAt(const Checkpoint& checkpoint) const {
  if (checkpoint.next == end()) return true;
  const std::uint64_t made = checkpoint.next - options_.all.first;
  const std::uint64_t in_archive =
      destination_.per_archive == 0 ? made : made % destination_.per_archive;
  return in_archive % kSegmentVariants == 0 && checkpoint.archive <= ArchiveOf(checkpoint.next);
}

bool ArchiveSink::IsIntact(const manifest::SealedFile& archive) const {
  diag::Findings ignored;
  return CheckSealed(destination_.Folder(), archive, request_.verify, ignored);
}

bool ArchiveSink::OpenArchive(std::uint64_t bytes, diag::Findings& findings) {
  const std::filesystem::path file = FileOf(checkpoint_.archive);
  // An archive is recognized by its name or by its members, not by its first bytes.
  const auto is_ours = [&](std::string_view) {
    return journal_.HasMadeArchive(file.filename().string()) || IsOwn(file);
  };
  if (!output::MayReplace(file, request_.force, 0, is_ours, findings)) return false;
  archive_ = output::PartFile::Open(file, findings);
  return archive_ && archive_->Truncate(bytes, findings);
}

bool ArchiveSink::CloseArchive(diag::Findings& findings) {
  if (!archive_ && !OpenArchive(0, findings)) return false;
  Checkpoint next = checkpoint_;
  ++next.archive;
  next.part = {};
  if (!CloseFile(next, findings)) return false;
  checkpoint_ = next;
  archive_.reset();
  return true;
}

bool ArchiveSink::CloseFile(const Checkpoint& next, diag::Findings& findings) {
  return archive_->Append(output::ArchiveEnd(destination_.format), findings) &&
         Seal({&archive_, 1}, next, findings);
}

bool ArchiveSink::Seal(std::span<const std::unique_ptr<output::PartFile>> parts,
                       const Checkpoint& next, diag::Findings& findings) {
  const auto note = [&](const auto& part) {
    return journal_.AddClosedArchive(
        {part->final_path().filename().string(), {part->size(), part->checksum()}}, next, findings);
  };
  const auto commit = [&](const auto& part) {
    return part->Commit(request_.if_changed, request_.durability, findings);
  };
  return std::ranges::all_of(parts, note) && std::ranges::all_of(parts, commit);
}

bool ArchiveSink::AppendAsset(const std::string& name, std::string_view bytes,
                              diag::Findings& findings) {
  output::Segment segment(destination_.format);
  return segment.Add(name, bytes, findings) && archive_->Append(segment.Bytes(), findings);
}

// Appends the assets of a chunk that the archive does not contain yet. The chunk's objects, which
// refer to these assets, must be appended after them.
bool ArchiveSink::AppendAssets(const ChunkResult& result, diag::Findings& findings) {
  for (const HashedAsset& asset : result.assets) {
    if (journal_.HasAsset(asset)) continue;
    if (!journal_.AddAsset(asset, findings)) return false;
    const auto bytes = output::ReadAsset(asset.source, asset.sha256, findings);
    if (!bytes || !AppendAsset(asset.name, *bytes, findings)) return false;
  }
  return true;
}

std::unique_ptr<Sink> MakeArchiveSink(const SinkOptions& options) {
  return std::make_unique<ArchiveSink>(options);
}

}  // namespace mjforge::batch
