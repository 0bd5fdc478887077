// Sinks: the outputs of a batch (a folder, archives, ...), which its leading process writes.

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
  std::uint64_t bytes = 0;  // size of their records, not compressed
};

/// Returns true if the variant of a record failed because its worker died.
bool HasWorkerDied(const manifest::Record& record);

/// Destination of a batch, as used by its leading process; takes the results in index order. This
/// base class discards everything.
class Sink {
 public:
  virtual ~Sink() = default;

  /// Opens the destination, and returns the variants of an earlier run that need not be made again.
  /// Returns nullopt, after adding a finding, if the destination cannot be written.
  virtual std::optional<ResumedVariants> Open(diag::Findings&) { return ResumedVariants(); }
  /// Policy for workers that write files themselves; valid after Open.
  virtual output::OverwritePolicy overwrite() const { return {}; }
  /// Writes a result; returns false, after adding a finding, if that fails. A sink that cannot use
  /// a partial result clears the members of the result that would be counted.
  virtual bool Take(ChunkResult&, diag::Findings&) { return true; }
  /// Finishes a complete batch: gives the output its final name.
  virtual bool Finish(diag::Findings&) { return true; }
  /// Removes the output of a batch that has no variant. `is_broken`: the batch was stopped, so that
  /// workers may have written files that no record mentions.
  virtual void Drop(bool /*is_broken*/) {}
  /// Removes the temporary files of workers that were killed.
  virtual void RemoveAbandoned() const {}
};

/// Arguments of sinks: `all` is the whole batch, `range` the request's shard of the batch, and
/// `batch` has the fields that all records have in common.
struct SinkOptions {
  const Request& request;
  IndexRange all;
  IndexRange range;
  const manifest::Record& batch;
};

/// Reads the records of `manifest` from the start. Stops after the records of `options.range`,
/// after `most` records, or before a record that is damaged, that `is_good` (unless null) rejects,
/// or whose variant failed because its worker died. Returns nullopt, after adding a finding, if a
/// record belongs to another batch or does not have the next index.
std::optional<ResumedVariants> ReadResumable(
    const std::filesystem::path& manifest, const SinkOptions& options,
    const std::function<bool(const manifest::Record&)>& is_good, diag::Findings& findings,
    std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// Adds the finding that `file` belongs to another batch, with the `difference` from this one.
void ReportOtherBatch(const std::filesystem::path& file, const std::string& difference,
                      diag::Findings& findings);

/// Makes the sink of the request's destination. The sink of standard output appends to `text`.
std::unique_ptr<Sink> MakeSink(const SinkOptions& options, std::string& text);

// Functions that make the sinks of folders, of archives and of families.
std::unique_ptr<Sink> MakeFolderSink(const SinkOptions& options);
std::unique_ptr<Sink> MakeArchiveSink(const SinkOptions& options);
std::unique_ptr<Sink> MakeFamilySink(const SinkOptions& options);

/// Returns true if `file` does not exist, is a manifest of mjforge, or `force` is set; otherwise
/// adds a finding.
bool MayReplaceManifest(const std::filesystem::path& file, bool force, diag::Findings& findings);
/// Removes the manifest of the whole batch, and its seal, before the first variant of a shard is
/// made, because the shard replaces files that the manifest describes. `batch`: the indices of all
/// shards. Leaves the manifest of other indices alone, and that of a family, because its .npz file
/// has the rows of the merge.
void RemoveMerged(const output::Destination& destination, const IndexRange& batch);
/// Returns true if `file` does not exist, is a family of mjforge, or `force` is set; otherwise adds
/// a finding.
bool MayReplaceFamily(const std::filesystem::path& file, bool force, diag::Findings& findings);

}  // namespace mjforge::batch
