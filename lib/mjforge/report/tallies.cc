// Counts of the values of parameters.

#include "mjforge/report/tallies.h"

#include <algorithm>
#include <cmath>

#include <fmt/ranges.h>

#include "mjforge/expr/expr.h"

namespace mjforge::report {
namespace {

// Maximum number of components of a vector that are counted.
constexpr std::size_t kMaxNumbers = 8;

void Count(Counts& counts, bool is_bad) {
  ++counts.all;
  if (is_bad) ++counts.bad;
}

}  // namespace

void NumberTally::Add(double value, bool is_bad) {
  all.Add(value);
  if (!is_bad) good.Add(value);
  if (is_bad) bad.Add(value);
  if (!(value > 0)) return;
  const double logarithm = std::log10(value);
  log_all.Add(logarithm);
  if (is_bad) log_bad.Add(logarithm);
}

void ParameterTally::Add(const sample::ParameterValue& value, bool is_bad) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    AddText(*text, is_bad);
  } else if (const auto* flag = std::get_if<bool>(&value)) {
    AddText(*flag ? "true" : "false", is_bad);
  } else if (const auto* list = std::get_if<std::vector<std::string>>(&value)) {
    AddText(fmt::format("{}", fmt::join(*list, ", ")), is_bad);
  } else if (const auto* number = std::get_if<double>(&value)) {
    numbers.resize(std::max<std::size_t>(numbers.size(), 1));
    numbers[0].Add(*number, is_bad);
    AddWhole(*number, is_bad);
  } else {
    const auto& vector = std::get<std::vector<double>>(value);
    const std::size_t count = std::min(vector.size(), kMaxNumbers);
    numbers.resize(std::max(numbers.size(), count));
    for (std::size_t i = 0; i < count; ++i) numbers[i].Add(vector[i], is_bad);
    all_whole_ = false;
  }
}

void ParameterTally::AddText(const std::string& text, bool is_bad) {
  if (texts_.size() < kMaxTexts || texts_.contains(text)) {
    Count(texts_[text], is_bad);
  } else {
    more_texts = true;
  }
}

void ParameterTally::AddWhole(double value, bool is_bad) {
  all_whole_ = all_whole_ && value == std::round(value);
  if (all_whole_ && whole_.size() <= kMaxWhole) Count(whole_[value], is_bad);
}

std::vector<std::pair<std::string, Counts>> ParameterTally::Values() const {
  std::vector<std::pair<std::string, Counts>> values;
  if (all_whole_ && whole_.size() <= kMaxWhole) {
    for (const auto& [value, counts] : whole_) values.emplace_back(expr::NumberText(value), counts);
  }
  values.insert(values.end(), texts_.begin(), texts_.end());
  return values;
}

void ParameterTallies::Add(
    const std::vector<std::pair<std::string, sample::ParameterValue>>& params, bool is_bad) {
  for (std::size_t i = 0; i < params.size(); ++i) {
    const std::string& name = params[i].first;
    // Search only if the position differs from that of the other records.
    auto known = list_.begin() + static_cast<std::ptrdiff_t>(std::min(i, list_.size()));
    if (known == list_.end() || known->name != name) {
      known = std::ranges::find(list_, name, &ParameterTally::name);
    }
    if (known == list_.end()) {
      known = list_.emplace(list_.end());
      known->name = name;
    }
    known->Add(params[i].second, is_bad);
  }
}

const ParameterTally* ParameterTallies::Find(const std::string& name) const {
  const auto found = std::ranges::find(list_, name, &ParameterTally::name);
  return found == list_.end() ? nullptr : &*found;
}

}  // namespace mjforge::report
