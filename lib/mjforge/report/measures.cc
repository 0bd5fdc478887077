// Table of the measures, and functions that read them from a variant's record.

#include "mjforge/report/measures.h"

#include <algorithm>
#include <array>

namespace mjforge::report {
namespace {

using manifest::Record;
using physics::Result;
using Number = std::optional<double>;

bool HasObject(const Record& record) { return record.nbody > 0; }

// Returns a result of the physics checks; nullopt if the checks did not run.
template <auto member>
Number Measured(const Record& record) {
  return record.physics ? Number((*record.physics).*member) : std::nullopt;
}

// Returns a result of the drop test; nullopt if the object was not dropped.
template <double Result::*member>
Number Dropped(const Record& record) {
  return record.physics && record.physics->dropped ? Measured<member>(record) : std::nullopt;
}

// Returns the worst result of all driven joints: the least if `least` is true, otherwise the
// largest. Returns nullopt if no joint was driven.
template <double Result::Joint::*member, bool least = false>
Number OfJoints(const Record& record) {
  if (!record.physics || record.physics->joints.empty()) return std::nullopt;
  double worst = record.physics->joints.front().*member;
  for (const Result::Joint& joint : record.physics->joints)
    worst = least ? std::min(worst, joint.*member) : std::max(worst, joint.*member);
  return worst;
}

constexpr std::array kMeasures = {
    Measure{MeasureId::kMass, "mass", "Mass", "kg", "The total of all bodies.",
            [](const Record& r) {
              return HasObject(r) ? Number(r.mass_properties.mass) : std::nullopt;
            }},
    Measure{MeasureId::kSize, "size", "Size", "m",
            "The largest side of the box around the parts that collide.", SizeOf},
    Measure{MeasureId::kAttempts, "attempt", "Draws rejected", "", "Before one was accepted.",
            [](const Record& r) { return Number(static_cast<double>(r.attempt)); }, false, true},
    Measure{MeasureId::kTimeToRest, "time", "Time to rest", "s",
            "Simulated time, for objects that came to rest.",
            [](const Record& r) {
              return r.physics && r.physics->at_rest ? Dropped<&Result::time>(r) : std::nullopt;
            },
            true},
    Measure{MeasureId::kDrift, "drift", "Drift", "m",
            "How far the centre of mass moved along the floor.", Dropped<&Result::drift>, true},
    Measure{MeasureId::kTilt, "tilt", "Tilt", "rad",
            "How far the object leans over at the end; near pi/2 it fell.", Dropped<&Result::tilt>,
            true},
    Measure{MeasureId::kPenetration, "penetration", "Penetration", "m",
            "The deepest contact during the drop.", Dropped<&Result::penetration>, true},
    Measure{MeasureId::kSink, "sink", "Depth at rest", "m", "The deepest contact at the end.",
            Dropped<&Result::sink>, true},
    Measure{MeasureId::kEnergyGain, "energy_gain", "Energy gain", "",
            "The largest gain since the start, as a share of mass * gravity * size.",
            Measured<&Result::energy_gain>, true},
    Measure{MeasureId::kOverlap, "overlap", "Overlap", "",
            "The share of the mass that is counted twice.", Measured<&Result::overlap>, true},
    Measure{MeasureId::kContacts, "ncon", "Contacts", "", "ncon: the most in one step.",
            Measured<&Result::ncon>, true, true},
    Measure{MeasureId::kConstraints, "nefc", "Constraint rows", "", "nefc: the most in one step.",
            Measured<&Result::nefc>, true, true},
    Measure{MeasureId::kJointReach, "joints.reach", "Reach of joints", "",
            "The share of its range that the least mobile joint reached.",
            OfJoints<&Result::Joint::reach, true>, true},
    Measure{MeasureId::kJointPenetration, "joints.penetration", "Depth between bodies", "m",
            "How deep bodies got into each other as joints were driven.",
            OfJoints<&Result::Joint::penetration>, true},
    Measure{MeasureId::kJointOvershoot, "joints.overshoot", "Overshoot of joints", "rad or m",
            "How far a joint was driven beyond its range.", OfJoints<&Result::Joint::overshoot>,
            true},
};

// MeasureOf requires kMeasures to be in the order of MeasureId.
static_assert([] {
  for (std::size_t i = 0; i < kMeasures.size(); ++i)
    if (static_cast<std::size_t>(kMeasures[i].id) != i) return false;
  return kMeasures.back().id == MeasureId::kJointOvershoot;
}());

}  // namespace

std::span<const Measure> Measures() { return kMeasures; }

const Measure& MeasureOf(MeasureId id) { return kMeasures[static_cast<std::size_t>(id)]; }

std::optional<double> SizeOf(const Record& record) {
  if (!HasObject(record)) return std::nullopt;
  return (record.bounds.aabb.max - record.bounds.aabb.min).maxCoeff();
}

}  // namespace mjforge::report
