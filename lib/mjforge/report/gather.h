#pragma once

// What a page is made from: one pass over a manifest, in bounded memory.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/manifest/manifest.h"
#include "mjforge/report/measures.h"
#include "mjforge/report/spread_sample.h"
#include "mjforge/report/tallies.h"
#include "mjforge/report/trials.h"

namespace mjforge::report {

/// Enough for a chart to show its shape, and few enough for a page.
inline constexpr std::size_t kMaxPoints = 1500;

/// A variant in the scatter of mass against size.
struct Point {
  double size = 0;  // m
  double mass = 0;  // kg
  bool is_bad = false;
};

/// A finding as a record holds it.
struct RecordedFinding {
  std::string severity;
  std::string code;
  std::string place;  // "hammer.yaml:3:5"; may be empty
  std::string message;
  std::string hint;
};
/// The findings of a record; entries that are not findings are skipped.
std::vector<RecordedFinding> FindingsOf(const manifest::Record& record);

struct CodeTally {
  std::uint64_t variants = 0;  // that have it at least once
  RecordedFinding example;     // of the first of them
  std::uint64_t index = 0;     // of that one
};

/// A variant that a page shows, why, and its whole record.
struct ShownVariant {
  enum class Reason { kFailed, kSlow, kSample };
  Reason reason = Reason::kSample;
  manifest::Record record;
};

class Gathered {
 public:
  /// To show up to `shown` variants.
  explicit Gathered(std::size_t shown);

  void Add(const manifest::Record& record);

  const NumberTally& Of(MeasureId id) const { return measures[static_cast<std::size_t>(id)]; }
  /// Whether any of them was tried, and not only loaded.
  bool HasPhysics() const { return Of(MeasureId::kContacts).all.count() > 0; }

  /// The failed first, then the slowest to come to rest, then others spread over the batch.
  std::vector<ShownVariant> Choose() const;

  std::optional<manifest::Record> first;
  std::uint64_t variants = 0;
  std::uint64_t last_index = 0;
  manifest::StatusCounts statuses;
  std::map<std::string, CodeTally> codes;
  ParameterTallies params;
  std::vector<NumberTally> measures;  // as Measures()
  Trials trials;
  SpreadSample<Point> points;
  std::string other_batch;  // how the first record that is of another batch differs

 private:
  void AddFindings(const manifest::Record& record);
  void AddToShown(const manifest::Record& record);

  std::size_t shown_;
  SpreadSample<manifest::Record> failed_;
  SpreadSample<manifest::Record> good_;
  std::vector<manifest::Record> slow_;  // a heap, the quickest of them on top
};

/// Reads the whole manifest; nothing, and a finding, if it cannot be read. Lines that are not
/// records are findings and are skipped, except one that is cut off in a manifest under
/// construction. `bad_lines`: how many there were.
std::optional<Gathered> Gather(const std::filesystem::path& manifest, std::size_t shown,
                               diag::Sources& sources, diag::Findings& findings,
                               std::uint64_t& bad_lines);

}  // namespace mjforge::report
