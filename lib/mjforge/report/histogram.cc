// Histogram with cells of 2^k that adapt to the range of the numbers.

#include "mjforge/report/histogram.h"

#include <algorithm>
#include <cmath>

namespace mjforge::report {
namespace {

// Bits of a cell number that a double represents exactly.
constexpr int kDigits = 52;
// Binary exponent of the smallest positive (denormal) double.
constexpr int kLeastExponent = -1074;

int ExponentOf(double value) { return value == 0 ? kLeastExponent : std::ilogb(value); }

}  // namespace

void Statistics::Add(double value) {
  min = count == 0 ? value : std::min(min, value);
  max = count == 0 ? value : std::max(max, value);
  ++count;
  const auto n = static_cast<double>(count);
  const double distance = value - mean;
  // The difference of two huge numbers of opposite signs overflows.
  mean += std::isfinite(distance) ? distance / n : value / n - mean / n;
  m2 += distance * (value - mean);
}

double Statistics::StandardDeviation() const {
  return count == 0 ? 0 : std::sqrt(m2 / static_cast<double>(count));
}

void Histogram::Add(double value) {
  if (!std::isfinite(value)) return;
  const bool is_first = count() == 0;
  numbers_.Add(value);
  int exponent = std::max({is_first ? kLeastExponent : exponent_, ExponentOf(min()) - kDigits,
                           ExponentOf(max()) - kDigits});
  if (is_first) {
    exponent_ = exponent;
    first_ = CellOf(value);
  } else if (exponent > exponent_) {
    Coarsen(exponent);
  }
  while (CellOf(max()) - CellOf(min()) >= kCells) Coarsen(exponent_ + 1);
  const std::int64_t lowest = CellOf(min());
  if (lowest < first_) cells_.insert(cells_.begin(), static_cast<std::size_t>(first_ - lowest), 0);
  first_ = lowest;
  cells_.resize(static_cast<std::size_t>(CellOf(max()) - first_ + 1));
  ++cells_[static_cast<std::size_t>(CellOf(value) - first_)];
}

double Histogram::Quantile(double q) const {
  const auto wanted = static_cast<std::uint64_t>(q * static_cast<double>(count()));
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    below += cells_[i];
    if (below > wanted) return std::clamp(MiddleOf(i), min(), max());
  }
  return max();
}

std::vector<std::uint64_t> Histogram::Bins(double lo, double hi, std::size_t bins) const {
  std::vector<std::uint64_t> counts(bins);
  const double width = hi / static_cast<double>(bins) - lo / static_cast<double>(bins);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i] == 0) continue;
    const double middle = MiddleOf(i);
    const double half = std::ldexp(0.5, exponent_);
    if (middle + half <= lo || middle - half > hi) continue;
    // A cell at either end counts in the bin at this end.
    const double place =
        std::clamp(middle / width - lo / width, 0.0, static_cast<double>(bins - 1));
    counts[static_cast<std::size_t>(place)] += cells_[i];
  }
  return counts;
}

std::int64_t Histogram::CellOf(double value) const {
  return static_cast<std::int64_t>(std::floor(std::ldexp(value, -exponent_)));
}

double Histogram::MiddleOf(std::size_t cell) const {
  const auto number = static_cast<double>(first_ + static_cast<std::int64_t>(cell));
  return std::ldexp(number + 0.5, exponent_);
}

// Merges cells so that they are 2^exponent wide, which is wider than before.
void Histogram::Coarsen(int exponent) {
  const int shift = std::min(exponent - exponent_, 63);
  const std::int64_t first = first_ >> shift;
  std::vector<std::uint64_t> cells;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const std::int64_t cell = (first_ + static_cast<std::int64_t>(i)) >> shift;
    cells.resize(static_cast<std::size_t>(cell - first + 1));
    cells.back() += cells_[i];
  }
  exponent_ = exponent;
  first_ = first;
  cells_ = std::move(cells);
}

}  // namespace mjforge::report
