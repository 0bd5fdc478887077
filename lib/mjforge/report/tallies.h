// Tallies: counts and distributions of the drawn values of parameters, for all and for failed
// variants.

#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/report/histogram.h"
#include "mjforge/sample/sample.h"

namespace mjforge::report {

/// Returns a parameter's value as text if the value is a text, a flag, or a list of texts or flags;
/// nullopt for numbers.
std::optional<std::string> TextOfWords(const sample::ParameterValue& value);

/// Returns the position of the item with this name; adds the item if it is missing. Looks at
/// `position` first, because all records of a batch have their parameters in the same order.
template <typename Item>
std::size_t FindOrAdd(std::size_t position, const std::string& name, std::vector<Item>& items) {
  if (position < items.size() && items[position].name == name) return position;
  const auto found = std::ranges::find(items, name, &Item::name);
  const auto index = static_cast<std::size_t>(found - items.begin());
  if (found == items.end()) items.emplace_back().name = name;
  return index;
}

/// Distribution of a number that each variant has.
struct NumberTally {
  void Add(double value, bool is_bad);
  void Append(const NumberTally& other);

  Statistics good;
  Histogram all;
  Histogram bad;
  // Decimal logarithms of the numbers above 0, for charts with a logarithmic axis.
  Histogram log_all;
  Histogram log_bad;
};

/// Numbers of all variants and of bad (failed or skipped) variants.
struct Counts {
  std::uint64_t all = 0;
  std::uint64_t bad = 0;

  std::uint64_t good() const { return all - bad; }
  void Append(const Counts& other) {
    all += other.all;
    bad += other.bad;
  }
};

/// The values of one parameter.
struct ParameterTally {
  /// Maximum number of different texts that Append() keeps. Add() has no limit, because otherwise
  /// the counts of the kept texts would be incomplete.
  static constexpr std::size_t kMaxTexts = 1000;
  /// Maximum number of different whole numbers whose values are counted separately, and maximum
  /// number of bars in a chart.
  static constexpr std::size_t kMaxWhole = 24;

  void Add(const sample::ParameterValue& value, bool is_bad);
  void Append(const ParameterTally& other);
  /// Returns the values for a bar chart: texts and booleans by name, whole numbers in ascending
  /// order if there are few. Empty if a histogram suits the parameter better.
  std::vector<std::pair<std::string, Counts>> Values() const;
  /// Returns the name of the i-th of `numbers` as expressions write it: `size.x`, `widths[4]`, or
  /// the parameter's name if there is a single number.
  std::string NameOf(std::size_t i) const;

  std::string name;
  std::vector<NumberTally> numbers;  // a tally for a number, or for each component of a vector
  bool more_texts = false;           // true: Append() dropped texts beyond kMaxTexts

 private:
  void AddText(const std::string& text, const Counts& counts);
  void AddWhole(double value, const Counts& counts);

  std::map<std::string, Counts> texts_;
  std::map<double, Counts> whole_;
  bool all_whole_ = true;
};

/// Tallies of the values that each parameter has in the variants of a batch. The parameters are in
/// the spec's order. `is_bad`: the variant failed or was skipped.
class ParameterTallies {
 public:
  void Add(const std::vector<std::pair<std::string, sample::ParameterValue>>& params, bool is_bad);
  void Append(const ParameterTallies& other);
  const std::vector<ParameterTally>& list() const { return list_; }
  /// Returns the tally of the parameter with this name; null if there is no such parameter.
  const ParameterTally* Find(const std::string& name) const;

 private:
  std::vector<ParameterTally> list_;
};

}  // namespace mjforge::report
