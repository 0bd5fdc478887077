#pragma once

// Many variants: made by worker processes, put in index order, resumed after a crash, split over
// machines and joined again. None of this changes the bytes of any file.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/forge/forge.h"
#include "mjforge/output/output.h"

namespace mjforge::batch {

using manifest::OnInvalid;
using manifest::Status;

struct Request {
  std::uint64_t first = 0;
  std::uint64_t count = 1;  // from 1 up; first + count - 1 fits
  output::Shard shard;      // which part of those to make
  forge::Options variant;   // except its folder, which the destination says

  output::Destination destination;
  bool force = false;       // replace files that mjforge did not make
  bool if_changed = false;  // leave files that would get the same bytes alone
  bool resume = false;      // go on with what an earlier run left
  bool verify = false;      // to resume: read finished archives again, too
  output::Durability durability = output::Durability::kBatch;
  /// A manifest or archive gets its name only if no variant failed, as Make expects of a target.
  bool all_or_nothing = false;

  std::uint64_t jobs = 0;  // worker processes; 0: as many as there are cores
  /// CPU time. A variant that takes more fails, and its worker is killed; so does one that takes
  /// more than WallLimit of wall time, because it hangs.
  std::chrono::duration<double> time_limit = std::chrono::seconds(30);
  const std::atomic<bool>* stop = nullptr;  // set by a signal: finish what is begun, and end
};

/// Generous, so that a busy machine does not fail a good variant.
constexpr std::chrono::duration<double> WallLimit(std::chrono::duration<double> time_limit) {
  return 10 * time_limit + std::chrono::seconds(5);
}

/// The exit status of a process that had too little memory (sysexits.h: EX_OSERR).
inline constexpr int kNoMemoryStatus = 71;

/// What is known of a variant when it is done.
struct FinishedVariant {
  std::uint64_t index = 0;
  std::string name;
  Status status = Status::kOk;
  std::uint64_t attempt = 0;
  std::string place;  // its file; empty: none
};

struct Summary : manifest::StatusCounts {
  std::uint64_t resumed = 0;  // of those, done by an earlier run
  std::uint64_t count = 0;    // to be made: the shard's
  bool interrupted = false;
  bool files_failed = false;  // some could not be read or written: it stopped there
  /// Of all variants. What is found at one place in many variants is here once,
  /// with a note of how many; at most kMaxFindings.
  diag::Findings findings;
  std::uint64_t more_findings = 0;  // places that did not fit
  /// Files that the variants made in this run depend on in addition to the spec's: attached MJCF
  /// with its includes, meshes, textures.
  std::set<std::string> inputs;
  std::string text;  // kStandardOutput: the object
};
inline constexpr std::size_t kMaxFindings = 50;

/// Called by the process that runs the batch; either may be missing.
struct Observer {
  std::function<void(const FinishedVariant&)> variant;  // in index order
  std::function<void(const Summary&)> progress;         // at least ten times a second
};

/// Makes the variants and writes them where the request says. Forks: the caller
/// must have no other threads. Where nothing could be made nothing is written.
Summary Run(const forge::Recipe& recipe, diag::Sources& sources, const Request& request,
            const Observer& observer);

/// The variants of a shard: its first one and how many. Shards are ranges one
/// after the other, of whole archives where the destination is a series.
struct IndexRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};
IndexRange RangeOfShard(const output::Shard& shard, const IndexRange& all,
                        const output::Destination& destination);

/// Joins the manifests of all shards beside or in `destination` into one, if they belong to one
/// batch and none is missing. What the shards' seals vouch for is checked: manifests and that all
/// files are there, archives with their size; with `verify`, the bytes of all. Returns the number
/// of variants; nothing, and findings, if that cannot be done.
std::optional<std::uint64_t> Merge(const output::Destination& destination, bool verify,
                                   diag::Sources& sources, diag::Findings& findings);

/// What was read and found as it was when its batch was done.
struct VerifyResult {
  std::uint64_t variants = 0;
  std::uint64_t files = 0;  // manifests, archives, objects
  std::uint64_t more_findings = 0;
};

/// Reads everything that seals vouch for: all batches in a folder, the batch of a manifest or of
/// its seal, or one archive. What is missing or was changed is a finding, up to kMaxFindings of
/// them.
VerifyResult Verify(const std::filesystem::path& what, diag::Sources& sources,
                    diag::Findings& findings);

}  // namespace mjforge::batch
