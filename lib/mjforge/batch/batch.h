// Batches of variants, made by worker processes: running, resuming, sharding, merging, verifying.
// The number of workers, interruptions and shards do not change the bytes of any output.

#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "mjforge/batch/finding_summary.h"
#include "mjforge/batch/interprocess.h"
#include "mjforge/diag/diag.h"
#include "mjforge/forge/forge.h"
#include "mjforge/output/output.h"

namespace mjforge::batch {

using manifest::OnInvalid;
using manifest::Status;

struct Request {
  std::uint64_t first = 0;
  std::uint64_t count = 1;  // at least 1; first + count - 1 must not overflow
  output::Shard shard;      // the part of the batch to make
  forge::Options variant;   // `folder` is ignored, because `destination` determines the folder

  output::Destination destination;
  bool force = false;       // replace files that mjforge did not make
  bool if_changed = false;  // leave files untouched that would get the same bytes
  bool resume = false;      // continue the batch of an earlier run
  bool verify = false;      // when resuming, also compare the bytes of finished archives
  output::Durability durability = output::Durability::kBatch;
  /// Manifest and archive get their final names only if no variant failed, so that the program make
  /// does not take them for finished targets.
  bool all_or_nothing = false;

  std::uint64_t jobs = 0;  // number of worker processes; 0: one per core
  /// Limit of CPU time for each variant. A variant that exceeds the limit fails, and its worker is
  /// killed. A variant that exceeds WallLimit() of wall time fails as well, because it hangs.
  std::chrono::duration<double> time_limit = std::chrono::seconds(30);
  const std::atomic<bool>* stop = nullptr;  // true: finish the current variants, then stop
};

/// Returns the limit of wall time for a variant: generous, so that a busy machine does not fail a
/// good variant.
constexpr std::chrono::duration<double> WallLimit(std::chrono::duration<double> time_limit) {
  return 10 * time_limit + std::chrono::seconds(5);
}

/// Exit status of a process that ran out of memory, the same as for failed input or output.
inline constexpr int kNoMemoryStatus = 3;

/// Result of one variant, as shown to an Observer.
struct FinishedVariant {
  std::uint64_t index = 0;
  std::string name;
  Status status = Status::kOk;
  std::uint64_t attempt = 0;
  std::string place;  // path of the variant's file; empty: no file
};

/// Counts of a batch's variants, and its findings.
struct Summary : manifest::StatusCounts {
  std::uint64_t resumed = 0;  // variants that an earlier run made; included in the counts
  std::uint64_t count = 0;    // variants of the shard
  bool interrupted = false;
  bool files_failed = false;  // the batch stopped because a file could not be read or written
  /// Findings of all variants, at most kMaxFindings. A finding that many variants have at one place
  /// appears once, with a note of their number.
  diag::Findings findings;
  std::uint64_t more_findings = 0;  // number of findings that are not in `findings`
  /// Files on which the variants of this run depend in addition to the spec's files: attached MJCF
  /// with its includes, meshes, textures.
  std::set<std::string> inputs;
  std::string text;  // MJCF of the object, if the destination is standard output
};
inline constexpr std::size_t kMaxFindings = 50;

/// Callbacks of the process that runs the batch; each may be empty.
struct Observer {
  std::function<void(std::uint64_t)> resumed;           // called first if Summary::resumed > 0
  std::function<void(const FinishedVariant&)> variant;  // called in index order
  std::function<void(const Summary&)> progress;         // called at least ten times a second
};

/// Makes the variants and writes them to the request's destination. Forks, so the caller must have
/// no other threads. Writes nothing if no variant could be made, unless the request is for a shard.
Summary Run(const forge::Recipe& recipe, diag::Sources& sources, const Request& request,
            const Observer& observer);

/// A range of consecutive variants, by their indices.
struct IndexRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};
/// Returns the variants of a shard. Shards are consecutive ranges, and ranges of whole archives if
/// the destination is a series.
IndexRange RangeOfShard(const output::Shard& shard, const IndexRange& all,
                        const output::Destination& destination);

/// Merges the manifests of all shards beside or in `destination` into one, and returns the number
/// of variants. Compares files with the shards' seals (lists of sizes and checksums): the bytes of
/// manifests, the sizes of archives, and the existence of all other files; with `verify`, the bytes
/// of all files. Returns nullopt, after adding findings, if a shard is missing, differs from its
/// seal or belongs to another batch.
std::optional<std::uint64_t> Merge(const output::Destination& destination, bool verify,
                                   diag::Sources& sources, diag::Findings& findings);

/// Counts of verified variants and files.
struct VerifyResult {
  std::uint64_t variants = 0;
  std::uint64_t files = 0;  // manifests, archives, objects
  std::uint64_t more_findings = 0;
};

/// Compares files with their seals: all batches in a folder, the batch of a manifest or of its
/// seal, or one archive. Each missing or changed file is a finding; findings beyond kMaxFindings
/// are counted.
VerifyResult Verify(const std::filesystem::path& what, diag::Sources& sources,
                    diag::Findings& findings);

}  // namespace mjforge::batch
