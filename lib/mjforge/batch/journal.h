// The manifest of a batch under construction, and the journal of checkpoints beside it.

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/batch/sink.h"

namespace mjforge::batch {

/// State of manifest and archives after a chunk (consecutive variants made by one worker).
struct Checkpoint {
  std::uint64_t next = 0;           // index of the first variant that is not written
  bytes::Fingerprint manifest;      // size and checksum of the manifest
  std::uint64_t archive = 0;        // number of the archive under construction
  bytes::Fingerprint part;          // size and checksum of the archive under construction
  std::uint64_t journal_bytes = 0;  // size of the journal after the line of this checkpoint
};

/// The manifest of a batch under construction, and the journal beside it, which has a checkpoint
/// for each chunk, with checksums of manifest and archive. Each line of the journal ends with its
/// own checksum; a damaged line and everything after it are ignored.
class Journal {
 public:
  explicit Journal(const SinkOptions& options);

  /// Opens manifest and journal. Returns false, after adding a finding, if another process has
  /// opened them, if existing files were not made by mjforge, or if the batch to resume has other
  /// options.
  bool Open(diag::Findings& findings);

  /// Returns true if an earlier run left a batch under construction.
  bool is_unfinished() const { return is_unfinished_; }
  /// Checkpoints of the earlier run whose checksum of the manifest matches, in order.
  const std::vector<Checkpoint>& checkpoints() const { return checkpoints_; }
  /// Returns the number of variants before a checkpoint.
  std::uint64_t CountBefore(const Checkpoint& checkpoint) const {
    return checkpoint.next - checkpoints_.front().next;
  }
  /// Complete archives, in the order of their completion.
  const std::vector<manifest::SealedFile>& closed_archives() const { return closed_archives_; }
  /// Seal (options, sizes and checksums of files) of the previous, finished batch; empty if there
  /// is none.
  const std::optional<manifest::Seal>& previous_seal() const { return previous_seal_; }
  /// Returns true if an earlier run or this run completed an archive with this name, according to
  /// the journal or the previous seal.
  bool HasMadeArchive(const std::string& archive) const { return made_archives_.contains(archive); }
  /// Names and SHA-256 of the assets of all records so far.
  const std::map<std::string, std::string>& assets() const { return seal_.assets; }
  /// SHA-256 of the assets of earlier runs with the same output and spec.
  const std::set<std::string>& made_assets() const { return made_assets_; }

  /// Path of the manifest while it is under construction, and its final path.
  const std::filesystem::path& part() const { return manifest_file_->temporary(); }
  const std::filesystem::path& file() const { return file_; }

  /// Empties manifest and journal, and adds the first checkpoint.
  bool Start(const Checkpoint& checkpoint, diag::Findings& findings);
  /// Removes everything after the checkpoint from manifest and journal.
  bool RollBackTo(const Checkpoint& checkpoint, diag::Findings& findings);
  bool AppendRecords(std::string_view lines, diag::Findings& findings) {
    return manifest_file_->Append(lines, findings);
  }
  /// Appends the first `count` bytes of an earlier manifest.
  bool AppendRecordsOf(const std::filesystem::path& manifest, std::uint64_t count,
                       diag::Findings& findings) {
    return manifest_file_->AppendFrom(manifest, count, findings);
  }
  /// Returns true if the folder or the archive under construction has an asset with that name and
  /// hash.
  bool HasAsset(const HashedAsset& asset) const {
    return assets_.contains({asset.name, asset.sha256});
  }
  /// Adds an asset of the folder or of the archive under construction. Returns false, after adding
  /// a finding, if an asset with that name or from that file has had another hash.
  bool AddAsset(const HashedAsset& asset, diag::Findings& findings);
  /// Adds a checkpoint to the journal, with the present size and checksum of the manifest in place
  /// of those in `checkpoint`.
  bool AddCheckpoint(const Checkpoint& checkpoint, diag::Findings& findings);
  /// Adds an archive that is about to be renamed to its final name, and the checkpoint after it.
  /// From then on, HasMadeArchive recognizes the archive.
  bool AddClosedArchive(manifest::SealedFile archive, const Checkpoint& next,
                        diag::Findings& findings);
  /// Completes the manifest, writes the seal, and renames the manifest to its final name.
  bool Finish(diag::Findings& findings);
  /// Removes the journal and the manifest under construction. If this run gave the manifest and the
  /// seal of a finished batch hidden names (has_hidden()), also restores their names, unless
  /// `shows_former` is false.
  void Drop(bool shows_former = true);
  /// Returns true if this run gave the manifest of a finished batch a hidden name.
  bool has_hidden() const { return has_hidden_; }

 private:
  bool MayReplaceOutputs(diag::Findings& findings) const;
  bool MayReplaceSnapshot(diag::Findings& findings) const;
  void RemoveEmptyFiles();
  std::uint64_t VariantsMade() const;
  bool IsOfThisBatch(diag::Findings& findings) const;
  void ReadPreviousSeal();
  void HideFormer();
  void ShowFormer();
  void RemoveFormer();
  void ReadJournal();
  bool ReadLine(std::string_view line, std::uint64_t end);
  /// Adds the asset of a line of the journal: a copy (`is_copy`), or the file from which a copy was
  /// made. Returns false if the line contains no file name.
  bool AddReadAsset(bool is_copy, const std::string& file, const std::string& sha256);
  bool ReadCheckpoint(std::istringstream& words, std::uint64_t end);
  bool AppendEarlierOutputs(diag::Findings& findings);
  bool AppendLine(const std::string& line, diag::Findings& findings);

  SinkOptions options_;
  std::filesystem::path file_;
  manifest::Seal seal_;  // seal of this run's batch
  std::unique_ptr<output::PartFile> manifest_file_;
  std::unique_ptr<output::PartFile> journal_file_;
  std::optional<manifest::Seal> previous_seal_;
  std::optional<manifest::Seal> journal_seal_;  // seal in the first line of the journal
  bool is_unfinished_ = false;
  bool has_hidden_ = false;
  std::vector<Checkpoint> checkpoints_;
  // Names and SHA-256 of the assets of the folder or of the archive under construction.
  std::set<std::pair<std::string, std::string>> assets_;
  // SHA-256 of the files that were copied as assets, by path. The name of a copy may differ after a
  // change of the file.
  std::map<std::string, std::string> sources_;
  std::vector<manifest::SealedFile> closed_archives_;
  std::set<std::string> made_archives_;  // names of archives closed by any run
  std::set<std::string> made_assets_;
};

}  // namespace mjforge::batch
