#pragma once

// Numbers in messages: rounded to what matters.

#include <string>

namespace mjforge::physics {

/// Three significant digits, and all digits before the point: "0.0123", "1.23", "1235".
std::string RoundedText(double value);

/// A speed (m/s), below 1 m/s in mm/s.
std::string SpeedText(double speed);

/// A joint's distance: of a slide (m) in mm, of others (rad) in deg.
std::string DistanceText(bool is_slide, double distance);

/// A number that is beyond a limit, and the limit, both with as few digits, from three on, as it
/// takes to see that.
struct Beyond {
  Beyond(double number, double bound);

  std::string value;
  std::string limit;
};

}  // namespace mjforge::physics
