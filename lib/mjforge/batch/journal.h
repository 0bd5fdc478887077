#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "mjforge/batch/sink.h"

namespace mjforge::batch {

/// How far manifest and archives are at the end of a chunk.
struct Checkpoint {
  std::uint64_t next = 0;  // index
  bytes::Prefix manifest;
  std::uint64_t archive = 0;        // the number of the one under construction
  bytes::Prefix part;               // of it
  std::uint64_t journal_bytes = 0;  // up to the end of its line
};

/// The manifest of a batch under construction, and the journal beside it, which says of each chunk
/// what was written, with checksums. Its lines have checksums as well, so a line that a crash or
/// anything else has changed is not believed, and neither is what follows it.
class Journal {
 public:
  explicit Journal(const SinkOptions& options);

  /// Takes manifest and journal. False, and a finding, if another process has them, what is there
  /// is not ours, or, to resume, belongs to another output.
  bool Open(diag::Findings& findings);

  /// Whether an earlier run left a batch under construction.
  bool is_unfinished() const { return is_unfinished_; }
  /// Its checkpoints that the manifest bears out, in order.
  const std::vector<Checkpoint>& checkpoints() const { return checkpoints_; }
  /// The closed archives that it noted, in order.
  const std::vector<manifest::SealedFile>& closed() const { return closed_; }
  /// What vouches for an earlier batch that was done; empty if nothing does.
  const std::optional<manifest::Seal>& previous_seal() const { return previous_seal_; }
  /// How the output of that differs from this one's, in words.
  std::string DifferenceFromPrevious() const;
  /// Whether an earlier run of this output made that archive.
  bool HasMadeArchive(const std::string& archive) const;
  /// SHA-256 of the assets of earlier runs of this output with the same spec.
  const std::set<std::string>& made_assets() const { return made_assets_; }

  /// The manifest under construction, and its final name.
  const std::filesystem::path& part() const { return manifest_file_->temporary(); }
  const std::filesystem::path& file() const { return file_; }

  /// Empties both, and notes the checkpoint before all others.
  bool Start(const Checkpoint& checkpoint, diag::Findings& findings);
  /// Removes what came after the checkpoint.
  bool RollBackTo(const Checkpoint& checkpoint, diag::Findings& findings);
  bool AppendRecords(std::string_view lines, diag::Findings& findings);
  /// Whether the folder or the archive under construction has an asset with that name and hash.
  bool HasAsset(const HashedAsset& asset) const;
  /// Notes one that comes into it. False, and a finding, if it was another before.
  bool AddAsset(const HashedAsset& asset, diag::Findings& findings);
  /// Notes a checkpoint: how far the archive is; the manifest's part of it is added.
  bool AddCheckpoint(const Checkpoint& checkpoint, diag::Findings& findings);
  /// Notes an archive that is to get its name, and the checkpoint after it. From then on the
  /// archive is known as ours.
  bool AddClosedArchive(manifest::SealedFile archive, const Checkpoint& next,
                        diag::Findings& findings);
  /// Seals the batch and gives the manifest its name.
  bool Finish(diag::Findings& findings);
  /// Removes both.
  void Drop();

 private:
  bool MayReplaceOutputs(diag::Findings& findings) const;
  void ReadPreviousSeal();
  void ReadJournal();
  bool ReadLine(std::string_view line, std::uint64_t end);
  bool ReadCheckpoint(std::istringstream& words, std::uint64_t end);
  bool AppendEarlierOutputs(diag::Findings& findings);
  bool AppendLine(const std::string& line, diag::Findings& findings);

  SinkOptions options_;
  std::filesystem::path file_;
  manifest::Seal seal_;  // of this run
  std::unique_ptr<output::PartFile> manifest_file_;
  std::unique_ptr<output::PartFile> journal_file_;
  std::optional<manifest::Seal> previous_seal_;
  std::optional<manifest::Seal> journal_seal_;  // as the journal has it
  bool is_unfinished_ = false;
  std::vector<Checkpoint> checkpoints_;
  std::vector<HashedAsset> assets_;  // in the folder, in the archive under construction
  std::vector<manifest::SealedFile> closed_;
  std::set<std::string> made_archives_;  // archives that were closed once
  std::set<std::string> made_assets_;
};

}  // namespace mjforge::batch
