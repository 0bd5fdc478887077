// Text of rounded numbers, speeds and distances for messages.
#pragma once

#include <string>

namespace mjforge::expr {

/// Returns the number rounded to `digits` significant digits, but with all digits before the point:
/// "0.0123", "1.23", "1235". Numbers from 1e9 on have an exponent instead.
std::string RoundedText(double value, int digits = 3);

/// Returns a speed, given in m/s, with its unit: in m/s, or in mm/s below 1 m/s.
std::string SpeedText(double speed);

/// Returns a distance between joint positions with its unit: for a slide (m) in mm, for a hinge or
/// ball (rad) in deg.
std::string DistanceText(bool is_slide, double distance);

/// Texts of a number and of the limit that it exceeds. The texts have as few digits as possible,
/// but at least three, and enough to show on which side of the limit the number is.
struct ExceededLimit {
  ExceededLimit(double number, double bound);

  std::string value;
  std::string limit;
};

}  // namespace mjforge::expr
