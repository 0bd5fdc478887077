#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "mjforge/batch/batch.h"
#include "mjforge/batch/message.h"

namespace mjforge::batch {

/// The variants of an unfinished batch that need not be made again.
struct ResumedVariants : manifest::StatusCounts {
  std::uint64_t bytes = 0;  // of the manifest
};

/// Whether a record's variant failed by chance: its worker died.
bool FailedByChance(const manifest::Record& record);

/// Where a batch goes, seen from the process that leads it. It takes the results
/// in index order. This one keeps nothing.
class Sink {
 public:
  virtual ~Sink() = default;

  /// Gets ready; returns what an earlier run left that need not be made again. Nothing, and a
  /// finding, if it cannot be written to.
  virtual std::optional<ResumedVariants> Open(diag::Findings&) { return ResumedVariants(); }
  /// How workers that write files themselves may overwrite; valid after Open.
  virtual output::OverwritePolicy overwrite() const { return {}; }
  /// From a result that it cannot use, it clears what would be counted.
  virtual bool Take(ChunkResult&, diag::Findings&) { return true; }
  /// Everything is there: gives the output its final name.
  virtual bool Finish(diag::Findings&) { return true; }
  /// Nothing could be made: removes what Open made.
  virtual void Drop() {}
};

/// `range` is what the request's shard makes of `all`; `batch` says what all its records
/// have in common.
struct SinkOptions {
  const Request& request;
  IndexRange all;
  IndexRange range;
  const manifest::Record& batch;
};

/// Reads the records of `manifest` from the start, at most `range`.count of them and at most
/// `bytes` bytes, while `is_good` accepts them and their indices count up from `range`.first.
/// Nothing, and a finding, if a record belongs to another batch than `batch`.
std::optional<ResumedVariants> ReadResumable(
    const std::filesystem::path& manifest, const SinkOptions& options,
    const std::function<bool(const manifest::Record&)>& is_good, diag::Findings& findings,
    std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max());

/// Adds that `file` belongs to another batch, and how that differs.
void ReportOtherBatch(const std::filesystem::path& file, const std::string& difference,
                      diag::Findings& findings);

/// The sink of the request's destination. `text` takes the object for standard output.
std::unique_ptr<Sink> MakeSink(const SinkOptions& options, std::string& text);

// One per kind of destination.
std::unique_ptr<Sink> MakeFolderSink(const SinkOptions& options);
std::unique_ptr<Sink> MakeArchiveSink(const SinkOptions& options);

/// Whether there is no file at `file`, it is a manifest of ours, or `force`. Else a finding.
bool MayReplaceManifest(const std::filesystem::path& file, bool force, diag::Findings& findings);

}  // namespace mjforge::batch
