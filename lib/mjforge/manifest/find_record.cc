// Finds the record of one variant in a manifest by bisection.

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {
namespace {

using Outcome = RecordReader::Outcome;
using Path = std::filesystem::path;

// Returns the variant index of the first record that starts after the offset `cut` in the file;
// nullopt if no record follows.
std::optional<std::uint64_t> IndexAfter(const Path& file, std::uint64_t cut) {
  diag::Sources sources;
  diag::Findings ignored;
  auto reader = RecordReader::Open(file, sources, ignored, {.begin = cut});
  Record record;
  Outcome outcome = Outcome::kBadLine;
  while (reader && outcome == Outcome::kBadLine) outcome = reader->Next(record);
  return outcome == Outcome::kRecord ? std::optional(record.index) : std::nullopt;
}

// Returns the section between two successive offsets in `cuts` that contains the record of variant
// `index` if the manifest is in index order. Finds the section by bisection.
bytes::FileSection SectionOf(const Path& file, std::uint64_t index,
                             const std::vector<std::uint64_t>& cuts) {
  const auto is_before = [&](std::uint64_t cut) {
    const std::optional<std::uint64_t> first = IndexAfter(file, cut);
    return first && *first <= index;
  };
  const auto end = std::partition_point(cuts.begin() + 1, cuts.end(), is_before);
  return end == cuts.end() ? bytes::FileSection{.begin = *(end - 1)}
                           : bytes::FileSection{.begin = *(end - 1), .end = *end};
}

// Returns the record with this index from a section of the manifest; nullopt if it is not there.
// Sets `is_read` to true in the latter case if all lines could be read.
std::optional<Record> FindIn(const bytes::FileSection& section, const Path& file,
                             std::uint64_t index, diag::Sources& sources, diag::Findings& findings,
                             bool& is_read) {
  auto reader = RecordReader::Open(file, sources, findings, section);
  Record record;
  Outcome outcome = Outcome::kBadLine;
  while (reader && (outcome == Outcome::kRecord || outcome == Outcome::kBadLine)) {
    outcome = reader->Next(record);
    if (outcome == Outcome::kRecord && record.index == index) return record;
  }
  is_read = outcome == Outcome::kEnd;
  return std::nullopt;
}

// Returns true if the manifest has a seal and the size that the seal states.
bool HasSeal(const Path& file) {
  std::string why_not;
  const std::optional<Seal> seal = ReadSealBeside(file, why_not);
  return seal && seal->manifest.file == file.filename() &&
         bytes::HasSize(file, seal->manifest.content.size, why_not);
}

}  // namespace

std::optional<Record> FindRecord(const Path& file, std::uint64_t index, diag::Sources& sources,
                                 diag::Findings& findings) {
  const std::optional<std::vector<std::uint64_t>> cuts = CutsOf(file, findings);
  if (!cuts) return std::nullopt;
  // Does not show findings of a section, because line numbers in a section are not those of the
  // file.
  diag::Sources section_sources;
  diag::Findings found;
  bool is_read = false;
  auto record = FindIn(SectionOf(file, index, *cuts), file, index, section_sources, found, is_read);
  if (record) return record;
  if (!found.empty() || !HasSeal(file))
    record = FindIn({}, file, index, sources, findings, is_read);
  if (!record && is_read) {
    findings.Add(diag::Code::kOutputBadManifest, {},
                 fmt::format("'{}' has no record with index {}", file.string(), index));
  }
  return record;
}

}  // namespace mjforge::manifest
