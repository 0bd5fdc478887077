// Axes of charts: linear and logarithmic scales, ticks at round numbers, and short texts of
// numbers.

#pragma once

#include <string>
#include <vector>

namespace mjforge::report {

enum class Scale { kLinear, kLogarithmic };

/// Axis of a chart: maps values to positions in the chart, and has ticks at round numbers.
class Axis {
 public:
  /// Maps values from lo to hi to positions from `start` to `end`. If lo equals hi, the axis covers
  /// a small range around this value. A logarithmic axis needs lo > 0 and hi > 0.
  Axis(Scale scale, double lo, double hi, double start, double end);

  double lo() const { return lo_; }
  double hi() const { return hi_; }
  double At(double value) const;

  struct Tick {
    double at = 0;  // position
    std::string label;
  };
  /// Returns the ticks of the axis: about `count`, at most twice as many.
  std::vector<Tick> Ticks(int count) const;
  /// Extends the range of the axis: a linear axis to the next ticks, a logarithmic axis by a factor
  /// of 1.15 at each end. `count` is the approximate number of ticks.
  void Round(int count);

 private:
  double Step(int count) const;
  std::vector<Tick> Decades(int count) const;

  Scale scale_;
  double lo_;
  double hi_;
  double start_;
  double end_;
};

/// Returns true if numbers from lo to hi need a logarithmic axis: all of them are above 0, hi is
/// much larger than lo, and most of them are much closer to lo than to hi.
bool WantsLogarithm(double lo, double hi, double median);

/// Returns a number with up to four significant digits ("0.25", "3.1e-07"), or rounded to a whole
/// number if its absolute value is from 1,000 to 10 million ("12345").
std::string ShortNumber(double value);

}  // namespace mjforge::report
