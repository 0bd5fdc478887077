// Division of a batch into chunks and shards.

#include "mjforge/batch/schedule.h"

#include <algorithm>

namespace mjforge::batch {
namespace {

// Returns whole * part / parts, rounded down. Intermediate results do not overflow.
std::uint64_t Portion(std::uint64_t whole, std::uint64_t part, std::uint64_t parts) {
  return whole / parts * part + whole % parts * part / parts;
}

}  // namespace

Schedule::Schedule(const IndexRange& all, const IndexRange& todo,
                   const output::Destination& destination, std::uint64_t jobs)
    : all_first_(all.first),
      next_(todo.first),
      end_(todo.first + todo.count),
      per_archive_(destination.per_archive),
      size_(kSegmentVariants) {
  if (!destination.PacksVariants()) {
    constexpr std::uint64_t kChunksPerJob = 8;  // small chunks keep all jobs busy until the end
    size_ = std::clamp<std::uint64_t>(todo.count / (kChunksPerJob * jobs), 1, kSegmentVariants);
  }
}

std::optional<Chunk> Schedule::Next() {
  if (next_ == end_) return std::nullopt;
  Chunk chunk;
  chunk.first = next_;
  const std::uint64_t position = next_ - all_first_;
  std::uint64_t room = end_ - next_;
  std::uint64_t in_archive = position;
  if (per_archive_ > 0) {
    chunk.archive = position / per_archive_;
    in_archive = position % per_archive_;
    room = std::min(room, per_archive_ - in_archive);
  }
  chunk.count = std::min(room, size_ - in_archive % size_);
  next_ += chunk.count;
  return chunk;
}

IndexRange RangeOfShard(const output::Shard& shard, const IndexRange& all,
                        const output::Destination& destination) {
  const std::uint64_t unit = std::max<std::uint64_t>(destination.per_archive, 1);
  const std::uint64_t units = all.count / unit + (all.count % unit > 0 ? 1 : 0);
  const auto start = [&](std::uint64_t index) {
    return std::min(all.count, Portion(units, index, shard.count) * unit);
  };
  return {all.first + start(shard.index), start(shard.index + 1) - start(shard.index)};
}

}  // namespace mjforge::batch
