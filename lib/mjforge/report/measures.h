#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "mjforge/manifest/manifest.h"

namespace mjforge::report {

/// What a record says of its object in one number.
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
  std::string_view key;  // as the record has it
  std::string_view title;
  std::string_view unit;
  std::string_view doc;
  std::optional<double> (*of)(const manifest::Record&);
  bool is_physics = false;  // of objects that were dropped or driven
  bool is_whole = false;    // a count
};

/// In the order of MeasureId.
std::span<const Measure> Measures();
const Measure& MeasureOf(MeasureId id);

/// The largest side of the object's box, m; nothing if there is no object.
std::optional<double> SizeOf(const manifest::Record& record);

}  // namespace mjforge::report
