// Portable random numbers for tests.

#pragma once

#include <random>

namespace mjforge::harness {

/// Random numbers that are equal on all machines, unlike those of the standard's distributions.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double Uniform(double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(engine_()) / 4294967296.0;
  }
  /// Returns a number from 0 to count - 1.
  int Integer(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937 engine_;
};

}  // namespace mjforge::harness
