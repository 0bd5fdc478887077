// Messages between the leading process of a batch and its workers: tasks, results, their encoding.

#pragma once

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

/// Consecutive variants that one worker makes as one task.
struct Chunk {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
  std::uint64_t archive = 0;  // number of the archive that contains the variants

  std::uint64_t end() const { return first + count; }
};

/// A variant that is not tried again, because its worker died while making it.
struct QuarantinedVariant {
  std::uint64_t index = 0;
  bool too_slow = false;
  std::string how;  // description of the worker's end: "was killed by SIGSEGV"
};

/// Work for a worker: the variants to make. Variants in `quarantined` are not made, but recorded as
/// failed.
struct Task {
  Chunk chunk;
  std::vector<QuarantinedVariant> quarantined;
};

/// Text of a file that findings quote, and that the worker has read but the leading process has
/// not.
struct SourceText {
  std::uint32_t number = 0;  // number in the worker's diag::Sources
  std::string name;
  std::string text;
};

/// An asset of an object, with its hash.
struct HashedAsset {
  std::string name;    // name of the file in the object's MJCF
  std::string source;  // path of the file; empty: the asset is generated
  std::string sha256;
  std::string made = {};  // content of a generated asset

  bool operator==(const HashedAsset&) const = default;
};

/// Result of a task, as the worker sends it to the leading process.
struct ChunkResult {
  Chunk chunk;
  std::uint64_t done = 0;  // finished variants; less than chunk.count if stopped or failed
  std::vector<Status> statuses;
  std::string_view lines;                 // records as lines or as a compressed frame, in `memory`
  std::string_view segment;               // segment of the archive, in `memory`
  std::string text;                       // MJCF of a single object
  std::vector<FinishedVariant> variants;  // empty if Observer::variant is empty
  std::vector<HashedAsset> assets;        // without duplicates
  std::vector<std::string> inputs;        // files that this worker has not reported before
  std::vector<FindingSummary::Group> findings;
  std::uint64_t more_findings = 0;
  std::vector<SourceText> sources;
  // True if the variant after the last finished one could not be written or lacked an input file.
  bool files_failed = false;
  diag::Findings output_findings;
  /// Owner of `lines` and `segment`; null in a worker, which owns them itself.
  std::shared_ptr<const void> memory;
};

/// Encodes a message.
std::string Encode(const Task& task);
std::string Encode(const ChunkResult& result);
/// Returns the size of an encoded result in bytes.
std::size_t EncodedSize(const ChunkResult& result);
/// Encodes a result into memory of EncodedSize(result) bytes.
void EncodeTo(char* out, const ChunkResult& result);
/// Decodes a message. Throws std::logic_error if the message is incomplete, which is a bug.
Task DecodeTask(std::string_view bytes);
/// Decodes a message. `lines` and `segment` of the result refer to `bytes`, which `memory` owns.
ChunkResult DecodeResult(std::string_view bytes, std::shared_ptr<const void> memory);

}  // namespace mjforge::batch
