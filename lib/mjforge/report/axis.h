#pragma once

#include <string>
#include <vector>

namespace mjforge::report {

enum class Scale { kLinear, kLogarithmic };

/// A chart's axis: maps values to places, with round numbers at its ticks.
class Axis {
 public:
  /// Values from lo to hi go to places from `start` to `end`. If lo and hi are the same, the axis
  /// leaves some room around them; on a logarithmic axis both are above 0.
  Axis(Scale scale, double lo, double hi, double start, double end);

  double lo() const { return lo_; }
  double hi() const { return hi_; }
  double At(double value) const;

  struct Tick {
    double at = 0;
    std::string label;
  };
  /// About `count` of them, never more than twice as many.
  std::vector<Tick> Ticks(int count) const;
  /// From lo or below to hi or above, so that it starts and ends at a tick.
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

/// Whether numbers from lo to hi need a logarithmic axis: they are all above 0 and most are much
/// closer to lo than to hi.
bool WantsLogarithm(double lo, double hi, double median);

/// A number for people: up to four significant digits, "0.25", "12000", "3.1e-07".
std::string Shown(double value);

}  // namespace mjforge::report
