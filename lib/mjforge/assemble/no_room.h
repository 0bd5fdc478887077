// Findings about bodies for which no place was found.

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "mjforge/assemble/field_reader.h"
#include "mjforge/assemble/place_names.h"

namespace mjforge::assemble {

/// Counts of the failed tries (poses that were checked) to place one body, by reason.
struct Misses {
  std::size_t count = 0;
  std::map<model::PlaceVerdict, std::size_t> verdicts;  // number of tries by verdict
  std::map<std::string, std::size_t> blockers;          // tries by the name of the blocking body
  double most_apart = 0;  // largest distance from a blocking body, m; 0 if all tries overlap it
  Eigen::Vector2d footprint = Eigen::Vector2d::Zero();  // smallest footprint of all tries, m
  Eigen::Vector3d size = Eigen::Vector3d::Zero();       // size of the body in the last try, m

  void Add(const model::PlaceResult& result, const PlaceNames& names);
  /// Returns true if all tries failed with this verdict.
  bool AreAll(model::PlaceVerdict verdict) const;
};

/// Facts about a body for which no place was found, for the message.
struct NoRoom {
  std::string body;
  std::string at;                         // name in `at:`: a region or a site
  std::string owner;                      // name of the body that has the region or site
  const model::Region* region = nullptr;  // null: the place is a site
  std::string beside;                     // name in `beside:`; empty if not given
  bool has_uv = false;                    // true if `uv:` gives the position in the region
  double clear = 0;                       // required distance from other bodies, m
  std::optional<double> widest_gap;       // diameter of the widest gap, m; nullopt if not searched
  std::size_t standing = 0;               // count of instances of the same entry that have a place
  std::size_t instances = 0;              // count of all instances of the entry; 0 if unknown
  diag::SourceMark mark;                  // position of `at:` in the text of the spec
  diag::SourceMark target;                // position of the region or site in the text of the spec
};

/// Adds a finding that no place was found for a body: the reason, the sizes of the place and of the
/// body's footprint, and the bodies that were most often in the way.
void ReportNoRoom(const NoRoom& facts, const Misses& misses, diag::Findings& findings);

}  // namespace mjforge::assemble
