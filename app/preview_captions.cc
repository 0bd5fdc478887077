// Captions of the variants on a contact sheet: choice and format of the parameters.
#include "preview_captions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

#include "mjforge/expr/expr.h"

namespace mjforge::app {
namespace {

using manifest::Record;
using sample::ParameterValue;

constexpr std::size_t kMaxParameters = 3;

// Returns the SI unit of a parameter's numbers, or an empty text. If the spec declares no unit, the
// unit is inferred from the text of the value: "m" from "22cm .. 30cm".
std::string_view UnitOf(const spec::Parameter* parameter) {
  if (parameter == nullptr) return "";
  if (parameter->unit == "1") return "";
  if (!parameter->unit.empty()) return parameter->unit;
  const std::string& text = parameter->source;
  for (const auto& [unit, si] :
       {std::pair("mm", "m"), std::pair("cm", "m"), std::pair("deg", "rad")}) {
    for (std::size_t at = text.find(unit); at != text.npos; at = text.find(unit, at + 1)) {
      if (at > 0 && expr::IsDigit(text[at - 1])) return si;
    }
  }
  return "";
}

// Returns "28.1 cm", "45 deg".
std::string NumberText(double number, std::string_view unit) {
  const double size = std::abs(number);
  if (unit == "rad") return fmt::format("{:.3g} deg", number * 180 / std::numbers::pi);
  if (unit == "m" && size > 0 && size < 0.01) return fmt::format("{:.3g} mm", 1000 * number);
  if (unit == "m" && size > 0 && size < 1) return fmt::format("{:.3g} cm", 100 * number);
  return fmt::format("{:.3g}{}{}", number, unit.empty() ? "" : " ", unit);
}

std::string TextOf(const ParameterValue& value, std::string_view unit) {
  if (const auto* number = std::get_if<double>(&value)) return NumberText(*number, unit);
  if (const auto* boolean = std::get_if<bool>(&value)) return *boolean ? "true" : "false";
  return std::get<std::string>(value);
}

// Visibility of a parameter's differences. Ranks: 0 for words, 1 for lengths, 2 for angles, 3 for
// numbers without a unit, 4 for mass and others that no picture shows. Lists are too long for
// captions and have no spread.
struct Difference {
  int rank = 0;
  double spread = 0;  // orders parameters of one rank; 0: all values are equal
};

Difference DifferenceOf(std::span<const Record> records, std::size_t parameter,
                        std::string_view unit) {
  std::set<std::string> texts;
  std::vector<double> numbers;
  for (const Record& record : records) {
    const ParameterValue& value = record.params[parameter].second;
    if (std::holds_alternative<std::vector<double>>(value) ||
        std::holds_alternative<std::vector<std::string>>(value) ||
        std::holds_alternative<std::vector<bool>>(value)) {
      return {};
    }
    texts.insert(TextOf(value, unit));
    if (const auto* number = std::get_if<double>(&value)) numbers.push_back(*number);
  }
  if (texts.size() < 2) return {};
  if (numbers.size() < records.size())
    return {0, static_cast<double>(texts.size()) / static_cast<double>(records.size())};
  const auto [min, max] = std::minmax_element(numbers.begin(), numbers.end());
  const double width = *max - *min;
  if (unit == "m") return {1, width};
  if (unit == "rad") return {2, width};
  return {unit.empty() ? 3 : 4, width / std::max(std::abs(*max), std::abs(*min))};
}

// Returns false for parameters that are computed from others or looked up in a table.
bool IsDrawn(const spec::ObjectSpec& spec, const std::string& name) {
  const spec::Parameter* parameter = spec.FindParameter(name);
  if (parameter == nullptr) return false;
  if (const auto* shared = std::get_if<spec::SharedParameter>(&parameter->value.form))
    parameter = &spec.shared[shared->file]->parameters[shared->position];
  const auto* draw = std::get_if<spec::Draw>(&parameter->value.form);
  return draw != nullptr && draw->rows == nullptr;
}

// Returns the parameters with the most visible differences, as (rank, -spread, index).
std::vector<std::tuple<int, double, std::size_t>> MostDifferent(std::span<const Record> records,
                                                                const spec::ObjectSpec& spec) {
  const auto& params = records.front().params;
  const bool any_drawn = std::any_of(params.begin(), params.end(),
                                     [&](const auto& param) { return IsDrawn(spec, param.first); });
  std::vector<std::tuple<int, double, std::size_t>> found;
  for (std::size_t i = 0; i < params.size(); ++i) {
    if (any_drawn && !IsDrawn(spec, params[i].first)) continue;
    const auto [rank, spread] =
        DifferenceOf(records, i, UnitOf(spec.FindParameter(params[i].first)));
    if (spread > 0) found.emplace_back(rank, -spread, i);
  }
  std::sort(found.begin(), found.end());
  found.resize(std::min(found.size(), kMaxParameters));
  return found;
}

}  // namespace

std::vector<std::vector<std::string>> MakeCaptions(std::span<const Record> records,
                                                   const spec::ObjectSpec& spec) {
  std::vector<std::vector<std::string>> captions;
  if (records.empty()) return captions;
  const auto parameters = MostDifferent(records, spec);
  for (const Record& record : records) {
    std::vector<std::string>& lines = captions.emplace_back();
    lines.push_back(fmt::format("#{}", record.index));
    for (const auto& [rank, spread, parameter] : parameters) {
      const auto& [name, value] = record.params[parameter];
      lines.push_back(fmt::format("{} {}", name, TextOf(value, UnitOf(spec.FindParameter(name)))));
    }
  }
  return captions;
}

}  // namespace mjforge::app
