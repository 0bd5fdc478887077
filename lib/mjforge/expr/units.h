#pragma once

// Private to the room.

#include <optional>
#include <string_view>

namespace mjforge::expr {

/// `value` of `unit` in SI; nothing for a unit that does not exist.
std::optional<double> InSi(double value, std::string_view unit);

}  // namespace mjforge::expr
