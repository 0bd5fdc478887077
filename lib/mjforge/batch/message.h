#pragma once

// What the batch's process and its workers say to each other.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/batch/batch.h"
#include "mjforge/batch/finding_summary.h"

namespace mjforge::batch {

/// Indices that one worker makes in one go.
struct Chunk {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
  std::uint64_t archive = 0;  // the number of the archive they go to

  std::uint64_t end() const { return first + count; }
};

/// A variant that is not tried again, because its worker died of it.
struct QuarantinedVariant {
  std::uint64_t index = 0;
  bool too_slow = false;
  std::string how;  // "was killed by SIGSEGV"
};

struct Task {
  Chunk chunk;
  std::vector<QuarantinedVariant> quarantined;
};

/// A text that findings point into and only the worker has read.
struct SourceText {
  std::uint32_t number = 0;  // among the worker's sources
  std::string name;
  std::string text;
};

/// A file that objects refer to.
struct HashedAsset {
  std::string name;    // in the object
  std::string source;  // file; empty: it is made
  std::string sha256;
  std::string made = {};  // its content

  bool operator==(const HashedAsset&) const = default;
};

struct ChunkResult {
  Chunk chunk;
  std::uint64_t done = 0;  // variants; fewer than the chunk's if stopped or failed
  std::vector<Status> statuses;
  std::string_view lines;                 // of the manifest, in `memory`
  std::string_view segment;               // of the archive, there, too
  std::string text;                       // of a single object
  std::vector<FinishedVariant> variants;  // if they are watched
  std::vector<HashedAsset> assets;        // each once
  std::vector<std::string> inputs;        // that this worker has not sent before
  std::vector<FindingSummary::Group> findings;
  std::uint64_t more_findings = 0;
  std::vector<SourceText> sources;
  // The variant after those done could not be written, or a file that it needs not be read.
  bool files_failed = false;
  diag::Findings output_findings;
  /// Holds `lines` and `segment`; null in a worker, which has them itself.
  std::shared_ptr<const void> memory;
};

std::string Encode(const Task& task);
std::string Encode(const ChunkResult& result);
/// A result as Encode makes it: how many bytes that are, and the same in memory of that size.
std::size_t EncodedSize(const ChunkResult& result);
void EncodeTo(char* out, const ChunkResult& result);
// Decode what Encode made. Bytes that are cut short or have a wrong length are a bug, and throw.
Task DecodeTask(std::string_view bytes);
/// Its `lines` and `segment` lie in `bytes`, which `memory` holds.
ChunkResult DecodeResult(std::string_view bytes, std::shared_ptr<const void> memory);

}  // namespace mjforge::batch
