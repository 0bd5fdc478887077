// Findings about bodies for which no place was found.

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "mjforge/assemble/field_reader.h"
#include "mjforge/assemble/place_names.h"

namespace mjforge::assemble {

/// The tries at a place for one body that failed.
struct Misses {
  std::size_t count = 0;
  std::map<model::PlaceVerdict, std::size_t> verdicts;
  std::map<std::string, std::size_t> blockers;          // by name in the spec
  Eigen::Vector2d footprint = Eigen::Vector2d::Zero();  // the smallest of all tries, m

  void Add(const model::PlaceResult& result, const PlaceNames& names);
  /// Returns true if all tries failed for this reason.
  bool AreAll(model::PlaceVerdict verdict) const;
};

/// The body for which no place was found, for messages.
struct NoRoom {
  std::string body;
  std::string at;
  const model::Region* region = nullptr;  // null: a site
  std::string beside;                     // empty: beside none
  bool has_uv = false;                    // `uv` says where in the region
  double clear = 0;                       // m
  std::optional<double> widest_gap;  // see Placer::WidestGap; nothing if it may not stand there
  std::size_t standing = 0;          // instances of the same entry that stand
  std::size_t instances = 0;         // all instances of the entry; 0: not known
  diag::SourceMark mark;             // place of the name in `at`
  diag::SourceMark target;           // place of the region or site
};

/// Adds the finding that names the reason, the sizes and what is in the way.
void ReportNoRoom(const NoRoom& what, const Misses& misses, diag::Findings& findings);

}  // namespace mjforge::assemble
