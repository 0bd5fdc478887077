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

/// Frequency of a code of findings.
struct CodeTally {
  std::uint64_t variants = 0;  // number of variants with this code
  RecordedFinding example;     // finding of the first of these variants
  std::uint64_t index = 0;     // index of the first of these variants
};

/// A variant that a page shows, with the reason and its record.
struct ShownVariant {
  enum class Reason { kFailed, kSlow, kSample };
  Reason reason = Reason::kSample;
  manifest::Record record;
};

/// Summary of the records of a manifest.
class ManifestSummary {
 public:
  /// `shown`: maximum number of variants that Choose returns.
  explicit ManifestSummary(std::size_t shown);

  void Add(const manifest::Record& record);
  /// Adds the summary of the next section of the manifest.
  void Append(const ManifestSummary& next);

  const NumberTally& Of(MeasureId id) const { return measures[static_cast<std::size_t>(id)]; }
  /// Returns true if physics checks ran for any variant.
  bool HasPhysics() const { return Of(MeasureId::kContacts).all.count() > 0; }

  /// Chooses failed variants, then the variants that took longest to come to rest, then other
  /// variants, spread over the batch.
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
  /// Difference between this batch and the first record of another batch; empty if there is none.
  std::string other_batch;

 private:
  void AddFindings(const manifest::Record& record);
  void AddSlow(const manifest::Record& record);

  std::size_t shown_;
  RandomSample<manifest::Record> failed_;
  RandomSample<manifest::Record> good_;
  std::vector<manifest::Record> slow_;  // slowest variants; a heap with the quickest on top
};

/// Reads the whole manifest, in sections that all cores share. The result does not depend on the
/// number of cores. Returns nullopt, and adds a finding, if the manifest cannot be read. Adds a
/// finding for each line that is not a record, except for a last line that is cut off in a manifest
/// under construction, and sets `bad_lines` to the number of these lines.
std::optional<ManifestSummary> Summarize(const std::filesystem::path& manifest, std::size_t shown,
                                         diag::Sources& sources, diag::Findings& findings,
                                         std::uint64_t& bad_lines);

}  // namespace mjforge::report
