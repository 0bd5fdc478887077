// Intervals that contain the values of a parameter in all variants of a spec.
#pragma once

#include <optional>
#include <vector>

namespace mjforge::spec {

struct Value;

/// Closed interval of the values that a number can have. An end is infinite if the number's
/// distribution is unbounded there.
struct Bounds {
  double low = 0;
  double high = 0;
};

/// Returns the bounds of a number. Returns nullopt for values of other types, and for numbers that
/// depend on other values.
std::optional<Bounds> BoundsOf(const Value& value);

/// Returns the bounds of each component of a vector. Returns an empty list if a component has no
/// bounds, and for values other than vectors whose components are given one by one.
std::vector<Bounds> BoundsOfComponents(const Value& value);

}  // namespace mjforge::spec
