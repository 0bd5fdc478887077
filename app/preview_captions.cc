#include "preview_captions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <variant>

namespace mjforge::app {
namespace {

using manifest::Record;
using sample::ParameterValue;

constexpr std::size_t kMostLines = 3;

std::string TextOf(const ParameterValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:.3g}", *number);
  if (const auto* boolean = std::get_if<bool>(&value)) return *boolean ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  std::string list;
  for (const double number : std::get<std::vector<double>>(value))
    list += fmt::format("{}{:.2g}", list.empty() ? "" : " ", number);
  return list;
}

// How much a parameter differs: of numbers the width of their range over the largest,
// of words the share of different ones, which counts half. Lists are too long to show.
double Spread(std::span<const Record> records, std::size_t parameter) {
  double min = 0;
  double max = 0;
  std::set<std::string> texts;
  bool numbers = true;
  for (const Record& record : records) {
    const ParameterValue& value = record.params[parameter].second;
    if (std::holds_alternative<std::vector<double>>(value)) return 0;
    texts.insert(TextOf(value));
    const auto* number = std::get_if<double>(&value);
    numbers = numbers && number != nullptr;
    if (!numbers) continue;
    min = texts.size() == 1 ? *number : std::min(min, *number);
    max = texts.size() == 1 ? *number : std::max(max, *number);
  }
  if (texts.size() < 2) return 0;
  if (numbers) return (max - min) / std::max(std::abs(max), std::abs(min));
  return 0.5 + 0.5 * static_cast<double>(texts.size()) / static_cast<double>(records.size());
}

// What is computed from others says less than those.
bool IsDrawn(const spec::ObjectSpec& spec, const std::string& name) {
  const spec::Parameter* parameter = spec.FindParameter(name);
  return parameter != nullptr && std::holds_alternative<spec::Draw>(parameter->value.form);
}

std::vector<std::size_t> MostDifferent(std::span<const Record> records,
                                       const spec::ObjectSpec& spec) {
  const auto& params = records.front().params;
  const bool any_drawn = std::any_of(params.begin(), params.end(),
                                     [&](const auto& param) { return IsDrawn(spec, param.first); });
  std::vector<std::pair<double, std::size_t>> spreads;
  for (std::size_t i = 0; i < params.size(); ++i) {
    if (any_drawn && !IsDrawn(spec, params[i].first)) continue;
    const double spread = Spread(records, i);
    if (spread > 0) spreads.emplace_back(-spread, i);
  }
  std::sort(spreads.begin(), spreads.end());
  spreads.resize(std::min(spreads.size(), kMostLines));
  std::vector<std::size_t> parameters;
  parameters.reserve(spreads.size());
  for (const auto& [spread, parameter] : spreads) parameters.push_back(parameter);
  std::sort(parameters.begin(), parameters.end());
  return parameters;
}

}  // namespace

std::vector<std::vector<std::string>> Captions(std::span<const Record> records,
                                               const spec::ObjectSpec& spec) {
  std::vector<std::vector<std::string>> captions;
  if (records.empty()) return captions;
  const std::vector<std::size_t> parameters = MostDifferent(records, spec);
  for (const Record& record : records) {
    std::vector<std::string>& lines = captions.emplace_back();
    lines.push_back(fmt::format("#{}", record.index));
    for (const std::size_t parameter : parameters) {
      const auto& [name, value] = record.params[parameter];
      lines.push_back(fmt::format("{} {}", name, TextOf(value)));
    }
  }
  return captions;
}

}  // namespace mjforge::app
