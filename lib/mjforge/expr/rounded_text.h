// Rounded numbers, speeds and distances for messages.
#pragma once

#include <string>

namespace mjforge::expr {

/// Rounds to this many significant digits, but keeps all digits before the point: "0.0123", "1.23",
/// "1235".
std::string RoundedText(double value, int digits = 3);

/// Formats a speed (m/s); below 1 m/s in mm/s.
std::string SpeedText(double speed);

/// Formats a joint's distance: a slide's (m) in mm, a hinge's or ball's (rad) in deg.
std::string DistanceText(bool is_slide, double distance);

/// Texts of a number beyond a limit, and of the limit, with the fewest digits, at least three, that
/// show on which side of the limit the number is.
struct ExceededLimit {
  ExceededLimit(double number, double bound);

  std::string value;
  std::string limit;
};

}  // namespace mjforge::expr
