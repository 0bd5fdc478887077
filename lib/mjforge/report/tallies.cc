// Counting of the drawn values of parameters: texts, whole numbers, and distributions of numbers.

#include "mjforge/report/tallies.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mjforge/expr/expr.h"

namespace mjforge::report {
namespace {

// Maximum number of components of a vector that are counted.
constexpr std::size_t kMaxNumbers = 8;

Counts One(bool is_bad) { return {1, is_bad ? 1U : 0U}; }

}  // namespace

std::optional<std::string> TextOfWords(const sample::ParameterValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* texts = std::get_if<std::vector<std::string>>(&value))
    return fmt::format("{}", fmt::join(*texts, ", "));
  if (const auto* flags = std::get_if<std::vector<bool>>(&value))
    return fmt::format("{}", fmt::join(*flags, ", "));
  return std::nullopt;
}

void NumberTally::Add(double value, bool is_bad) {
  all.Add(value);
  if (!is_bad) good.Add(value);
  if (is_bad) bad.Add(value);
  if (!(value > 0)) return;
  const double logarithm = std::log10(value);
  log_all.Add(logarithm);
  if (is_bad) log_bad.Add(logarithm);
}

void NumberTally::Append(const NumberTally& other) {
  good.Append(other.good);
  all.Append(other.all);
  bad.Append(other.bad);
  log_all.Append(other.log_all);
  log_bad.Append(other.log_bad);
}

void ParameterTally::Add(const sample::ParameterValue& value, bool is_bad) {
  if (const auto text = TextOfWords(value)) {
    AddText(*text, One(is_bad));
  } else if (const auto* number = std::get_if<double>(&value)) {
    numbers.resize(std::max<std::size_t>(numbers.size(), 1));
    numbers[0].Add(*number, is_bad);
    AddWhole(*number, One(is_bad));
  } else {
    const auto& vector = std::get<std::vector<double>>(value);
    const std::size_t count = std::min(vector.size(), kMaxNumbers);
    numbers.resize(std::max(numbers.size(), count));
    for (std::size_t i = 0; i < count; ++i) numbers[i].Add(vector[i], is_bad);
    all_whole_ = false;
  }
}

std::string ParameterTally::NameOf(std::size_t i) const {
  constexpr std::array kComponents = {"x", "y", "z", "w"};
  if (numbers.size() == 1) return name;
  if (numbers.size() > kComponents.size()) return fmt::format("{}[{}]", name, i);
  return fmt::format("{}.{}", name, kComponents[i]);
}

void ParameterTally::AddText(const std::string& text, const Counts& counts) {
  texts_[text].Append(counts);
}

void ParameterTally::AddWhole(double value, const Counts& counts) {
  all_whole_ = all_whole_ && value == std::round(value);
  if (all_whole_ && whole_.size() <= kMaxWhole) whole_[value].Append(counts);
}

void ParameterTally::Append(const ParameterTally& other) {
  numbers.resize(std::max(numbers.size(), other.numbers.size()));
  for (std::size_t i = 0; i < other.numbers.size(); ++i) numbers[i].Append(other.numbers[i]);
  more_texts = more_texts || other.more_texts;
  for (const auto& [text, counts] : other.texts_) {
    const bool is_listed = texts_.size() < kMaxTexts || texts_.contains(text);
    if (is_listed) AddText(text, counts);
    more_texts = more_texts || !is_listed;
  }
  all_whole_ = all_whole_ && other.all_whole_;
  for (const auto& [value, counts] : other.whole_) AddWhole(value, counts);
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
  for (std::size_t i = 0; i < params.size(); ++i)
    list_[FindOrAdd(i, params[i].first, list_)].Add(params[i].second, is_bad);
}

void ParameterTallies::Append(const ParameterTallies& other) {
  for (std::size_t i = 0; i < other.list_.size(); ++i)
    list_[FindOrAdd(i, other.list_[i].name, list_)].Append(other.list_[i]);
}

const ParameterTally* ParameterTallies::Find(const std::string& name) const {
  return diag::Find(list_, name, &ParameterTally::name);
}

}  // namespace mjforge::report
