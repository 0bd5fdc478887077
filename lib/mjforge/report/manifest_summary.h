// Summary of a manifest (a JSON record for each variant of a batch), made in one pass, on all cores
// and in bounded memory.

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/manifest/manifest.h"
#include "mjforge/report/measures.h"
#include "mjforge/report/random_sample.h"
#include "mjforge/report/structure_tallies.h"
#include "mjforge/report/tallies.h"
#include "mjforge/report/test_tallies.h"

namespace mjforge::report {

/// Maximum number of points in the scatter plot.
inline constexpr std::size_t kMaxPoints = 1500;

/// A variant in the scatter plot of mass against size.
struct Point {
  double size = 0;  // m
  double mass = 0;  // kg
  bool is_bad = false;
};

/// A finding that was read from a record of the manifest.
struct RecordedFinding {
  std::string severity;
  std::string code;
  std::string place;  // "hammer.yaml:3:5"; may be empty
  std::string message;
  std::string hint;
};
/// Returns the findings of a record; ignores entries that are not findings.
std::vector<RecordedFinding> FindingsOf(const manifest::Record& record);

/// Frequency of a code of findings ("physics/thin") in a batch.
struct CodeTally {
  std::uint64_t variants = 0;  // number of variants with this code
  RecordedFinding example;     // finding of the first of these variants
  std::uint64_t index = 0;     // index of the first of these variants
};

/// A variant that a page shows: its record, and the reason why it was chosen.
struct ShownVariant {
  enum class Reason { kFailed, kSlow, kSample };
  Reason reason = Reason::kSample;
  manifest::Record record;
};

/// Summary of the records of a manifest.
class ManifestSummary {
 public:
  /// `shown` is the maximum number of variants that Choose() returns.
  explicit ManifestSummary(std::size_t shown);

  void Add(const manifest::Record& record);
  /// Appends the summary of the next section of the manifest, made with the same `shown`.
  void Append(const ManifestSummary& next);

  const NumberTally& Of(MeasureId id) const { return measures[static_cast<std::size_t>(id)]; }
  /// Returns true if physics checks ran for any variant.
  bool HasPhysics() const { return Of(MeasureId::kContacts).all.count() > 0; }

  /// Returns variants to show: failed and skipped variants, then the variants that took longest to
  /// come to rest, then other variants, spread over the batch.
  std::vector<ShownVariant> Choose() const;

  std::optional<manifest::Record> first;
  std::uint64_t variants = 0;
  std::uint64_t last_index = 0;
  manifest::StatusCounts statuses;
  std::map<std::string, CodeTally> codes;
  ParameterTallies params;
  StructureTallies structures;
  std::vector<NumberTally> measures;  // in the order of Measures()
  TestTallies tests;
  RandomSample<Point> points;
  /// Description of the difference between the first record and the first record of another batch;
  /// empty if all records are of one batch.
  std::string other_batch;

 private:
  void AddFindings(const manifest::Record& record);
  void AddSlow(const manifest::Record& record);

  std::size_t shown_;
  RandomSample<manifest::Record> failed_;
  RandomSample<manifest::Record> good_;
  // Good variants that took longest to come to rest; a heap with the quickest of them on top.
  std::vector<manifest::Record> slow_;
};

/// Reads the whole manifest, in sections that all cores share. The result does not depend on the
/// number of cores. Sets `bad_lines` to the number of lines that are not records, except for a last
/// line that is cut off in a manifest under construction. Adds findings for the first of these
/// lines (RecordReader::kMaxBadLines). Returns nullopt, and adds a finding, if the manifest cannot
/// be read or has too many such lines (RecordReader::kMaxSkippedLines).
std::optional<ManifestSummary> Summarize(const std::filesystem::path& manifest, std::size_t shown,
                                         diag::Sources& sources, diag::Findings& findings,
                                         std::uint64_t& bad_lines);

}  // namespace mjforge::report
