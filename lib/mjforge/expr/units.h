#pragma once

// Private to the room.

#include <optional>
#include <string_view>

#include "mjforge/expr/dimension.h"

namespace mjforge::expr {

/// What a unit that a number may carry is in SI. Two whole numbers rather than a factor: 15 / 1000
/// is the double nearest to 0.015, 15 * 0.001 is not.
struct KnownUnit {
  Dimension dimension;
  double numerator;
  double denominator;
};
/// Nothing for a unit that does not exist.
std::optional<KnownUnit> FindKnownUnit(std::string_view unit);

}  // namespace mjforge::expr
