// Measures: numbers in a variant's record, such as mass, size and results of physics checks, whose
// distributions a report shows.

#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "mjforge/manifest/manifest.h"

namespace mjforge::report {

/// Identifiers of the measures, in the order in which a report shows them.
enum class MeasureId {
  kMass,
  kSize,
  kAttempts,
  kTimeToRest,
  kDrift,
  kTilt,
  kPenetration,
  kSink,
  kEnergyGain,
  kOverlap,
  kContacts,
  kConstraints,
  kJointReach,
  kJointPenetration,
  kJointOvershoot
};

struct Measure {
  MeasureId id;
  std::string_view key;  // name of the number in the record
  std::string_view title;
  std::string_view unit;
  std::string_view doc;
  std::optional<double> (*of)(const manifest::Record&);
  bool is_physics = false;  // true: result of a physics check
  bool is_whole = false;    // true: the values are counts
};

/// All measures, in the order of MeasureId.
std::span<const Measure> Measures();
const Measure& MeasureOf(MeasureId id);

/// Returns the largest side of the object's bounding box, m; nullopt if there is no object.
std::optional<double> SizeOf(const manifest::Record& record);

}  // namespace mjforge::report
