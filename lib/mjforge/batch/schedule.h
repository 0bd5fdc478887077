#pragma once

#include <cstdint>
#include <optional>

#include "mjforge/batch/batch.h"
#include "mjforge/batch/message.h"

namespace mjforge::batch {

/// Variants in one segment of an archive. Fixed, because a compressed archive's bytes depend on
/// where its segments end.
inline constexpr std::uint64_t kSegmentVariants = 64;

/// Cuts a range of indices into chunks, in order.
class Schedule {
 public:
  /// `all` is the whole batch, from which archives are counted; `todo` is what is left to do. For a
  /// folder, chunks are small enough that all jobs have work.
  Schedule(const IndexRange& all, const IndexRange& todo, const output::Destination& destination,
           std::uint64_t jobs);

  std::optional<Chunk> Next();

 private:
  std::uint64_t all_first_;
  std::uint64_t next_;
  std::uint64_t end_;
  std::uint64_t per_archive_;  // 0: one for all
  std::uint64_t size_;
};

}  // namespace mjforge::batch
