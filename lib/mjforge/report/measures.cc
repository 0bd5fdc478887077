#include "mjforge/report/measures.h"

#include <array>

namespace mjforge::report {
namespace {

using manifest::Record;
using Number = std::optional<double>;

bool HasObject(const Record& record) { return record.nbody > 0; }

constexpr std::array kMeasures = {
    Measure{MeasureId::kMass, "Mass", "kg", "Of all bodies.", false,
            [](const Record& r) { return HasObject(r) ? Number(r.mass_properties.mass) : Number(); }},
    Measure{MeasureId::kSize, "Size", "m", "The largest side of the box that holds it.", false,
            [](const Record& r) { return SizeOf(r); }},
    Measure{MeasureId::kAttempts, "Draws rejected", "", "Before one was accepted.", false,
            [](const Record& r) { return Number(static_cast<double>(r.attempt)); }},
};

}  // namespace

std::span<const Measure> Measures() { return kMeasures; }

std::optional<double> SizeOf(const Record& record) {
  if (!HasObject(record)) return std::nullopt;
  return (record.bounds.aabb.max - record.bounds.aabb.min).maxCoeff();
}

}  // namespace mjforge::report
