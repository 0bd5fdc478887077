// Facts about objects for the pages of a gallery: masses, sizes, joints, targets.
#pragma once

#include <string>
#include <vector>

#include "mjforge/forge/forge.h"
#include "mjforge/report/report.h"

namespace mjforge::app {

/// Returns a length or an angle with its unit: "28.1 cm", "45 deg".
std::string LengthText(double meters);
std::string AngleText(double radians);

/// Returns the name of an element without the object's prefix: "hinge" of "door_hinge".
std::string ShortName(const model::Object& object, const std::string& name);

/// Returns the ranges of mass and size of variants, and all other facts of a typical variant.
std::vector<report::Fact> FactsOf(const std::vector<manifest::Record>& variants,
                                  const forge::Variant& typical);
/// Returns the facts of a card: "0.3 to 0.9 kg, 24 to 31 cm, 2 joints".
std::string ShortFacts(const std::vector<manifest::Record>& variants, const model::Object& typical);

/// Returns tables of joints, actuators, sensors, sites for grasps, and regions.
std::vector<report::FeatureTable> FeaturesOf(const model::Object& object);
/// Returns a table of the targets (--target) for which a variant can be written.
report::FeatureTable TargetsOf(const forge::Recipe& recipe, diag::Sources& sources,
                               const forge::Options& options, std::uint64_t index);

}  // namespace mjforge::app
