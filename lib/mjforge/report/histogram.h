// Statistics and histograms of numbers, in one pass and bounded memory.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mjforge::report {

/// Count, range, mean and variance of numbers, by Welford's algorithm, which is accurate for any
/// count. Rounding errors of mean and variance depend on the order of the numbers.
struct Statistics {
  std::uint64_t count = 0;
  double min = 0;
  double max = 0;
  double mean = 0;
  double m2 = 0;  // sum of squared differences from the mean
  void Add(double value);
  /// Adds the numbers of other statistics, by the formula of Chan, Golub and LeVeque.
  void Append(const Statistics& other);
  /// Returns the standard deviation of the population (dividing by count, not count - 1).
  double StandardDeviation() const;
};

/// Histogram of numbers whose range is not known in advance, in bounded memory. The width of a cell
/// is the smallest power of two for which kCells cells cover all numbers, unless doubles cannot
/// represent such small cells. If a new number requires more cells, neighbouring cells are merged.
/// The counts do not depend on the order of the numbers.
class Histogram {
 public:
  static constexpr std::int64_t kCells = 8192;

  /// Ignores numbers that are not finite.
  void Add(double value);
  void Append(Histogram other);

  std::uint64_t count() const { return numbers_.count; }
  /// Statistics of the numbers, which do not depend on the cells; 0 if there are no numbers.
  double min() const { return numbers_.min; }
  double max() const { return numbers_.max; }
  double mean() const { return numbers_.mean; }
  double StandardDeviation() const { return numbers_.StandardDeviation(); }
  /// Returns the q-quantile, with an error of at most the width of a cell.
  double Quantile(double q) const;
  /// Returns the counts in `bins` intervals of equal width from lo to hi, where lo < hi. All
  /// numbers of a cell count in the bin that contains the cell's middle, or in the nearest bin.
  /// Ignores cells outside of [lo, hi].
  std::vector<std::uint64_t> Bins(double lo, double hi, std::size_t bins) const;

 private:
  std::int64_t CellOf(double value) const;
  double MiddleOf(std::size_t cell) const;
  void Coarsen(int exponent);
  void Cover();
  void CountPending() const;

  Statistics numbers_;
  int exponent_ = 0;                          // a cell is 2^exponent_ wide
  std::int64_t first_ = 0;                    // cells_[0] starts at first_ * 2^exponent_
  mutable std::vector<std::uint64_t> cells_;  // from the cell of min() to the cell of max()
  // Numbers that are not counted in cells_ yet. Counting many numbers at once is faster, because
  // the cells of all histograms of a batch do not fit into the processor's cache.
  mutable std::vector<double> pending_;
};

}  // namespace mjforge::report
