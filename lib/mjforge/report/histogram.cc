// Statistics, and a histogram whose cells have a width of 2^k that adapts to the range of the
// numbers.

#include "mjforge/report/histogram.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mjforge::report {
namespace {

// Largest number of bits of a cell number. Doubles represent such numbers exactly.
constexpr int kDigits = 52;
constexpr std::size_t kMaxPending = 1024;
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
  // Divides first if the difference of two huge numbers of opposite signs overflows.
  mean += std::isfinite(distance) ? distance / n : value / n - mean / n;
  m2 += distance * (value - mean);
}

void Statistics::Append(const Statistics& other) {
  if (other.count == 0) return;
  if (count == 0) {
    *this = other;
    return;
  }
  const auto n = static_cast<double>(count);
  const auto m = static_cast<double>(other.count);
  const double share = m / (n + m);
  const double distance = other.mean - mean;
  mean += std::isfinite(distance) ? distance * share : other.mean * share - mean * share;
  m2 += other.m2 + distance * distance * n * share;
  min = std::min(min, other.min);
  max = std::max(max, other.max);
  count += other.count;
}

double Statistics::StandardDeviation() const {
  return count == 0 ? 0 : std::sqrt(m2 / static_cast<double>(count));
}

void Histogram::Add(double value) {
  if (!std::isfinite(value)) return;
  const bool is_covered = count() > 0 && min() <= value && value <= max();
  numbers_.Add(value);
  if (!is_covered) Cover();
  pending_.push_back(value);
  if (pending_.size() == kMaxPending) CountPending();
}

void Histogram::CountPending() const {
  for (const double value : pending_) ++cells_[static_cast<std::size_t>(CellOf(value) - first_)];
  pending_.clear();
}

void Histogram::Append(Histogram other) {
  if (count() == 0) std::swap(*this, other);
  if (other.count() == 0) return;
  other.CountPending();
  numbers_.Append(other.numbers_);
  if (other.exponent_ > exponent_) Coarsen(other.exponent_);
  Cover();
  if (exponent_ > other.exponent_) other.Coarsen(exponent_);
  for (std::size_t i = 0; i < other.cells_.size(); ++i)
    cells_[static_cast<std::size_t>(other.first_ - first_) + i] += other.cells_[i];
}

// Makes the cells wider, if necessary, and adds cells until the cells cover all numbers from min()
// to max().
void Histogram::Cover() {
  const bool is_empty = cells_.empty();
  const int exponent = std::max({is_empty ? kLeastExponent : exponent_, ExponentOf(min()) - kDigits,
                                 ExponentOf(max()) - kDigits});
  if (is_empty) {
    exponent_ = exponent;
    first_ = CellOf(min());
  } else if (exponent > exponent_) {
    Coarsen(exponent);
  }
  while (CellOf(max()) - CellOf(min()) >= kCells) Coarsen(exponent_ + 1);
  const std::int64_t lowest = CellOf(min());
  if (lowest < first_) cells_.insert(cells_.begin(), static_cast<std::size_t>(first_ - lowest), 0);
  first_ = lowest;
  cells_.resize(static_cast<std::size_t>(CellOf(max()) - first_ + 1));
}

double Histogram::Quantile(double q) const {
  const auto wanted = static_cast<std::uint64_t>(q * static_cast<double>(count()));
  std::uint64_t below = 0;
  CountPending();
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    below += cells_[i];
    if (below > wanted) return std::clamp(MiddleOf(i), min(), max());
  }
  return max();
}

std::vector<std::uint64_t> Histogram::Bins(double lo, double hi, std::size_t bins) const {
  std::vector<std::uint64_t> counts(bins);
  CountPending();
  const double width = hi / static_cast<double>(bins) - lo / static_cast<double>(bins);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i] == 0) continue;
    const double middle = MiddleOf(i);
    const double half = std::ldexp(0.5, exponent_);
    if (middle + half <= lo || middle - half > hi) continue;
    // Counts a cell whose middle is outside of [lo, hi] in the bin at this end.
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

// Merges neighbouring cells into cells of the width 2^exponent, which must be wider than before.
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
