// Sink (output of a batch) that writes archives, and base class of the sink that writes families.

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "mjforge/batch/journaled_sink.h"

namespace mjforge::batch {

/// Sink that writes archives. Appends segments in index order; each segment contains the files of
/// one chunk of variants. Resumes an unfinished archive.
class ArchiveSink : public JournaledSink {
 public:
  explicit ArchiveSink(const SinkOptions& options) : JournaledSink(options) {
    checkpoint_.archive = ArchiveOf(options_.range.first);
  }

  bool Take(ChunkResult& result, diag::Findings& findings) override;
  bool Finish(diag::Findings& findings) override;
  void Drop(bool is_broken) override;

 protected:
  std::optional<ResumedVariants> Continue(diag::Findings& findings) override;
  /// Returns the path of the archive with this number.
  virtual std::filesystem::path FileOf(std::uint64_t number) const {
    return destination_.Archive(number);
  }
  /// Returns true if mjforge made `file`, so that the file may be replaced.
  virtual bool IsOwn(const std::filesystem::path& file) const {
    return output::IsObjectArchive(file);
  }
  /// Returns the number of closed archives that need not be made again, if the first `intact` of
  /// the `files` closed files have not changed.
  virtual std::uint64_t CountClosed(std::uint64_t intact, std::uint64_t /*files*/) const {
    return intact;
  }
  /// Appends an asset to the archive under construction.
  virtual bool AppendAsset(const std::string& name, std::string_view bytes,
                           diag::Findings& findings);
  /// Completes the file under construction, and gives the file its final name. `next` is the
  /// checkpoint (state of all outputs) after this file.
  virtual bool CloseFile(const Checkpoint& next, diag::Findings& findings);

  std::unique_ptr<output::PartFile>& file() { return archive_; }
  /// Records complete files in the journal, and gives the files their final names. `next` is the
  /// checkpoint after these files.
  bool Seal(std::span<const std::unique_ptr<output::PartFile>> parts, const Checkpoint& next,
            diag::Findings& findings);

 private:
  std::uint64_t end() const { return options_.range.first + options_.range.count; }
  std::uint64_t ArchiveOf(std::uint64_t index) const;
  std::optional<ResumedVariants> ContinueFinished(diag::Findings& findings);
  std::optional<ResumedVariants> ContinueUnfinished(diag::Findings& findings);
  std::optional<Checkpoint> LastValidCheckpoint(std::uint64_t most) const;
  bool CanContinueAt(const Checkpoint& checkpoint) const;
  bool IsIntact(const manifest::SealedFile& archive) const;
  bool OpenArchive(std::uint64_t bytes, diag::Findings& findings);
  bool CloseArchive(diag::Findings& findings);
  bool AppendAssets(const ChunkResult& result, diag::Findings& findings);

  std::unique_ptr<output::PartFile> archive_;
  bool is_complete_ = false;  // an earlier run finished the batch
};

}  // namespace mjforge::batch
