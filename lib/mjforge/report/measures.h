// Measures of a variant that a report shows: mass, size, results of physics checks.

#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "mjforge/manifest/manifest.h"

namespace mjforge::report {

/// Identifiers of the measures, which are numbers in a record that describe the object.
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
  bool is_physics = false;  // result of a physics check
  bool is_whole = false;    // a count
};

/// All measures, in the order of MeasureId.
std::span<const Measure> Measures();
const Measure& MeasureOf(MeasureId id);

/// Returns the largest side of the object's bounding box, m; nullopt if there is no object.
std::optional<double> SizeOf(const manifest::Record& record);

}  // namespace mjforge::report
