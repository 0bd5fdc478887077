// Text of rounded numbers, speeds and distances for messages.
#pragma once

#include <string>

namespace mjforge::expr {

/// Returns the number rounded to `digits` significant digits, but with all digits before the point:
/// "0.0123", "1.23", "1235". Numbers of magnitude 1e9 or more, or below 1e-4, may have an exponent.
std::string RoundedText(double value, int digits = 3);

/// Returns a speed, given in m/s, as text with its unit: mm/s below 1 m/s, otherwise m/s.
std::string SpeedText(double speed);

/// Returns the distance between two positions of a joint as text with its unit: in mm for a slide
/// (given in m), in deg for a hinge or ball joint (given in rad).
std::string DistanceText(bool is_slide, double distance);

/// Texts of a number and of the limit that it exceeds. The texts have as few digits as possible,
/// but at least three, and enough to show on which side of the limit the number is.
struct ExceededLimit {
  ExceededLimit(double number, double bound);

  std::string value;
  std::string limit;
};

}  // namespace mjforge::expr
