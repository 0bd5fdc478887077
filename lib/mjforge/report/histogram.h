#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mjforge::report {

/// What numbers add up to. Exact enough for any count: the mean is Welford's.
struct Numbers {
  std::uint64_t count = 0;
  double min = 0;
  double max = 0;
  double mean = 0;
  double m2 = 0;  // sum of squared distances from the mean
  void Add(double value);
  /// Of the whole population; 0 for one.
  double StandardDeviation() const;
};

/// Counts of numbers whose range is not known in advance, in bounded memory. The cells are as wide
/// as the smallest power of two that lets all numbers fit in kCells of them, so that they depend on
/// the numbers alone and not on their order: neighbours are merged in pairs when a number falls
/// outside.
class Histogram {
 public:
  static constexpr std::int64_t kCells = 8192;

  /// Numbers that are not finite are skipped.
  void Add(double value);

  std::uint64_t count() const { return numbers_.count; }
  /// Exact; 0 without numbers.
  double min() const { return numbers_.min; }
  double max() const { return numbers_.max; }
  double mean() const { return numbers_.mean; }
  /// Of the whole population.
  double StandardDeviation() const { return numbers_.StandardDeviation(); }
  /// The number below which a share `q` of all numbers lies, to within the width of a cell.
  double Quantile(double q) const;
  /// Counts in `bins` intervals of one width from lo to hi, lo < hi. A cell counts in the bin that
  /// holds its middle; a middle at lo or hi counts in the bin there, and one outside is left out.
  std::vector<std::uint64_t> Bins(double lo, double hi, std::size_t bins) const;

 private:
  std::int64_t CellOf(double value) const;
  double MiddleOf(std::size_t cell) const;
  void Coarsen(int exponent);

  Numbers numbers_;
  int exponent_ = 0;                  // a cell is 2^exponent_ wide
  std::int64_t first_ = 0;            // the number of cells_[0]: it starts at first_ * 2^exponent_
  std::vector<std::uint64_t> cells_;  // from that of min() to that of max()
};

}  // namespace mjforge::report
