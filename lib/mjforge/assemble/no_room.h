// Findings about bodies for which no place was found.

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "mjforge/assemble/field_reader.h"
#include "mjforge/assemble/place_names.h"

namespace mjforge::assemble {

/// Counts of the failed tries to place one body.
struct Misses {
  std::size_t count = 0;
  std::map<model::PlaceVerdict, std::size_t> verdicts;
  std::map<std::string, std::size_t> blockers;          // tries by the name of the body in the way
  Eigen::Vector2d footprint = Eigen::Vector2d::Zero();  // smallest footprint of all tries, m

  void Add(const model::PlaceResult& result, const PlaceNames& names);
  /// Returns true if all tries failed for this reason.
  bool AreAll(model::PlaceVerdict verdict) const;
};

/// The body for which no place was found, for messages.
struct NoRoom {
  std::string body;
  std::string at;
  const model::Region* region = nullptr;  // null: the place is a site
  std::string beside;                     // body of `beside:`; empty if not given
  bool has_uv = false;                    // `uv:` gives the position in the region
  double clear = 0;                       // distance to keep, m
  std::optional<double> widest_gap;       // Placer::WidestGap, m; nullopt with `uv:` or `beside:`
  std::size_t standing = 0;               // instances of the same entry that have a place
  std::size_t instances = 0;              // all instances of the entry; 0: not known
  diag::SourceMark mark;                  // place of `at:` in the spec
  diag::SourceMark target;                // place of the region or site in the spec
};

/// Adds a finding with the reason, the sizes and the bodies in the way.
void ReportNoRoom(const NoRoom& what, const Misses& misses, diag::Findings& findings);

}  // namespace mjforge::assemble
