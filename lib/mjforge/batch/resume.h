#ifndef MJFORGE_BATCH_RESUME_H_
#define MJFORGE_BATCH_RESUME_H_

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "mjforge/batch/batch.h"

namespace mjforge::batch {

/// The variants of an unfinished batch that need not be made again.
struct Kept {
  std::uint64_t ok = 0;
  std::uint64_t failed = 0;
  std::uint64_t skipped = 0;
  std::uint64_t bytes = 0;  // of the manifest

  std::uint64_t count() const { return ok + failed + skipped; }
};

/// Reads the records of `manifest` from the start, at most `range`.count and `bytes`
/// bytes of them, while `is_good` says so and each follows the one before from
/// `range`.first on. Nothing, and a finding, if there is a record of another batch than
/// `batch` or the file cannot be read.
std::optional<Kept> ReadKept(const std::filesystem::path& manifest, std::uint64_t bytes,
                             const Range& range, const manifest::Record& batch,
                             const std::function<bool(const manifest::Record&)>& is_good,
                             diag::Findings& findings);

/// Whether a record's variant failed by chance: its worker died.
bool FailedByChance(const manifest::Record& record);

}  // namespace mjforge::batch

#endif  // MJFORGE_BATCH_RESUME_H_
