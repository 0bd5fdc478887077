#pragma once

// How often each value was drawn, for good variants and for those that failed.

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/report/histogram.h"
#include "mjforge/sample/sample.h"

namespace mjforge::report {

/// A number of each variant.
struct NumberTally {
  void Add(double value, bool is_bad);

  Numbers good;
  Histogram all;
  Histogram bad;
  // Decimal logarithms of the numbers above 0, for charts that want them.
  Histogram log_all;
  Histogram log_bad;
};

struct Counts {
  std::uint64_t all = 0;
  std::uint64_t bad = 0;

  std::uint64_t good() const { return all - bad; }
};

/// The values of one parameter.
struct ParameterTally {
  /// If there are more texts than this, only the first are counted.
  static constexpr std::size_t kMaxTexts = 1000;
  /// Whole numbers are values of their own while they are this few: as many as a chart has bars.
  static constexpr std::size_t kMaxWhole = 24;

  void Add(const sample::ParameterValue& value, bool is_bad);
  /// Each value that has a bar of its own: texts and booleans by name, whole numbers in
  /// order while they are few. Empty: it is better shown as a histogram.
  std::vector<std::pair<std::string, Counts>> Values() const;

  std::string name;
  std::uint64_t count = 0;
  std::vector<NumberTally> numbers;  // one; for a vector, one per component
  bool more_texts = false;           // there were more than kMaxTexts

 private:
  void AddText(const std::string& text, bool is_bad);
  void AddWhole(double value, bool is_bad);

  std::map<std::string, Counts> texts_;
  std::map<double, Counts> whole_;
  bool all_whole_ = true;
};

/// The parameters of a batch, in the spec's order.
class ParameterTallies {
 public:
  void Add(const std::vector<std::pair<std::string, sample::ParameterValue>>& params, bool is_bad);
  const std::vector<ParameterTally>& list() const { return list_; }
  /// Null if there is none of that name.
  const ParameterTally* Find(const std::string& name) const;

 private:
  std::vector<ParameterTally> list_;
};

}  // namespace mjforge::report
