// Tests of dividing batches into chunks and shards.

#include "mjforge/batch/schedule.h"

#include <catch2/catch.hpp>

namespace mjforge::batch {
namespace {

using Kind = output::Destination::Kind;

output::Destination To(Kind kind, std::uint64_t per_archive = 0) {
  output::Destination destination;
  destination.kind = kind;
  destination.per_archive = per_archive;
  return destination;
}

std::vector<Chunk> All(Schedule schedule) {
  std::vector<Chunk> chunks;
  while (const auto chunk = schedule.Next()) chunks.push_back(*chunk);
  return chunks;
}

TEST_CASE("chunks cover a range, in order and without a gap") {
  for (const auto& destination :
       {To(Kind::kFolder), To(Kind::kArchive), To(Kind::kArchives, 100)}) {
    for (const std::uint64_t count : {1, 63, 64, 65, 1000}) {
      std::uint64_t next = 41;
      for (const Chunk& chunk : All(Schedule({41, count}, {41, count}, destination, 3))) {
        CHECK(chunk.first == next);
        CHECK(chunk.count > 0);
        CHECK(chunk.count <= kSegmentVariants);
        next = chunk.end();
      }
      CHECK(next == 41 + count);
    }
  }
}

TEST_CASE("a small batch has work for all jobs") {
  CHECK(All(Schedule({0, 20}, {0, 20}, To(Kind::kFolder), 4)).size() == 20);
}

TEST_CASE("segments of an archive end at the same indices, wherever a run begins") {
  const auto destination = To(Kind::kArchives, 100);
  const std::vector<Chunk> all = All(Schedule({5, 250}, {5, 250}, destination, 2));
  REQUIRE(all.size() == 5);
  CHECK(all[0].count == 64);
  CHECK(all[1].count == 36);
  CHECK(all[2].first == 105);
  CHECK(all[2].archive == 1);
  CHECK(all[4].archive == 2);
  CHECK(all[4].count == 50);
  const std::vector<Chunk> rest = All(Schedule({5, 250}, {69, 186}, destination, 7));
  REQUIRE(rest.size() == 4);
  CHECK(rest[0].first == all[1].first);
  CHECK(rest[0].count == all[1].count);
}

TEST_CASE("shards are ranges that make up the whole, of whole archives in a series") {
  for (const auto& destination : {To(Kind::kFolder), To(Kind::kArchives, 30)}) {
    for (const std::uint64_t count : {1, 7, 100, 101, 2000}) {
      for (const std::uint64_t shards : {1, 2, 7, 8, 150}) {
        std::uint64_t next = 10;
        for (std::uint64_t i = 0; i < shards; ++i) {
          const IndexRange range = RangeOfShard({i, shards}, {10, count}, destination);
          CHECK(range.first == next);
          next += range.count;
          const bool whole = destination.per_archive == 0 || next == 10 + count ||
                             (next - 10) % destination.per_archive == 0;
          CHECK(whole);
        }
        CHECK(next == 10 + count);
      }
    }
  }
}

}  // namespace
}  // namespace mjforge::batch
