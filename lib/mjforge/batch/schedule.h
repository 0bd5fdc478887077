// Division of a batch into chunks.

#pragma once

#include <cstdint>
#include <optional>

#include "mjforge/batch/batch.h"
#include "mjforge/batch/message.h"

namespace mjforge::batch {

/// Number of variants in a segment, the part of an archive that one worker makes at a time.
/// Constant, because the bytes of a compressed archive depend on the ends of its segments.
inline constexpr std::uint64_t kSegmentVariants = 64;

/// Divides a range of variants into consecutive chunks, each of which is a worker's task.
class Schedule {
 public:
  /// Divides `todo`, the variants to make. Archives are counted from the start of `all`, the whole
  /// batch. For a folder, chunks are small enough that all jobs have work.
  Schedule(const IndexRange& all, const IndexRange& todo, const output::Destination& destination,
           std::uint64_t jobs);

  /// Returns the next chunk, or nullopt after the last one.
  std::optional<Chunk> Next();

 private:
  std::uint64_t all_first_;
  std::uint64_t next_;
  std::uint64_t end_;
  std::uint64_t per_archive_;  // variants per archive; 0: a single archive
  std::uint64_t size_;         // variants per chunk
};

}  // namespace mjforge::batch
