// Choice of a control on the page of `mjforge customize` for each parameter of a spec: its kind,
// bounds and heading.

#include "mjforge/customize/controls.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "mjforge/expr/expr.h"

namespace mjforge::customize {
namespace {

using spec::Distribution;
using spec::Value;

// Returns true if all bounds are from 0 to 1, like those of red, green, blue and opacity.
bool AreShares(const std::vector<spec::Bounds>& bounds) {
  return std::ranges::all_of(
      bounds, [](const spec::Bounds& each) { return each.low >= 0 && each.high <= 1; });
}

bool IsRgba(const Value& value) {
  const std::vector<spec::Bounds> bounds = spec::BoundsOfComponents(value);
  return bounds.size() == 4 && AreShares(bounds);
}

bool HasColorOptions(const Value& value) {
  const auto* draw = std::get_if<spec::Draw>(&value.form);
  return draw != nullptr && value.components == 4 && std::ranges::all_of(draw->arguments, IsRgba);
}

bool IsColor(const spec::Parameter& parameter, const Value& value,
             const std::vector<spec::Bounds>& bounds) {
  if (value.components != 3 && value.components != 4) return false;
  if (std::holds_alternative<spec::HsvColor>(value.form)) return true;
  const bool is_named = std::ranges::any_of(std::array{"color", "colour", "rgb"}, [&](auto word) {
    return parameter.name.find(word) != std::string::npos;
  });
  return is_named && AreShares(bounds);
}

std::string_view KindOf(const spec::Parameter& parameter, const Value& value, bool has_choices,
                        const std::vector<spec::Bounds>& bounds) {
  const auto* draw = std::get_if<spec::Draw>(&value.form);
  if (draw != nullptr && draw->rows != nullptr) return "fixed";
  if (HasColorOptions(value)) return "color";
  if (has_choices) return "choice";
  if (value.is_list) return "list";
  if (value.type == expr::Type::kBoolean) return "switch";
  if (value.type == expr::Type::kText) return "text";
  if (IsColor(parameter, value, bounds)) return "color";
  return value.components > 1 ? "vector" : "number";
}

// Returns true if a parameter is written as a whole number or is drawn from whole numbers.
bool IsWhole(const spec::Parameter& parameter, const Value& value) {
  if (const auto* draw = std::get_if<spec::Draw>(&value.form))
    return draw->distribution == Distribution::kInteger ||
           draw->distribution == Distribution::kPoisson;
  return !parameter.source.empty() &&
         parameter.source.find_first_not_of("0123456789") == std::string::npos;
}

// Counts, for each first word of a name ("handle" of "handle_length"), the parameters without a
// section whose names begin with this word.
std::map<std::string, int> CountPrefixes(const spec::ObjectSpec& spec) {
  std::map<std::string, int> counts;
  for (const spec::Parameter& parameter : spec.parameters) {
    if (parameter.section.empty())
      ++counts[parameter.name.substr(0, parameter.name.find_first_of("_."))];
  }
  return counts;
}

// Returns the heading under which a parameter is shown: its section or, without a section, the
// first word of its name if another parameter's name begins with this word. Returns an empty text
// if there is no heading.
std::string GroupOf(const spec::Parameter& parameter, const std::map<std::string, int>& prefixes) {
  if (!parameter.section.empty()) return diag::SafeText(parameter.section);
  std::string prefix = parameter.name.substr(0, parameter.name.find_first_of("_."));
  return prefixes.at(prefix) > 1 ? prefix : "";
}

// Writes the members `low` and `high`: a list of bounds each, or null if there are none.
void WriteBounds(diag::Json& json, const std::vector<spec::Bounds>& bounds) {
  for (const bool is_low : {true, false}) {
    json.Key(is_low ? "low" : "high");
    if (bounds.empty()) {
      json.Value(nullptr);
      continue;
    }
    json.List(bounds, [&](const spec::Bounds& each) { json.Value(is_low ? each.low : each.high); });
  }
}

std::vector<spec::Bounds> AllBounds(const Value& value) {
  if (value.components > 1) return spec::BoundsOfComponents(value);
  const std::optional<spec::Bounds> bounds = spec::BoundsOf(value);
  return bounds ? std::vector{*bounds} : std::vector<spec::Bounds>();
}

}  // namespace

void WriteControls(diag::Json& json, const spec::ObjectSpec& spec) {
  const std::map<std::string, int> prefixes = CountPrefixes(spec);
  json.Each(spec.parameters, [&](const spec::Parameter& parameter) {
    const Value& value = spec.ValueOf(parameter);
    const std::vector<spec::Bounds> bounds = AllBounds(value);
    const std::optional<std::string> choices = spec::ConstantChoices(value);
    json.Member("name", parameter.name);
    json.Member("group", GroupOf(parameter, prefixes));
    json.Member("unit", parameter.unit);
    json.Member("doc", diag::SafeText(parameter.doc));
    json.Member("spec", diag::SafeText(parameter.source));
    json.Member("kind", KindOf(parameter, value, choices.has_value(), bounds));
    json.Member("components", value.components);
    json.Member("whole", IsWhole(parameter, value));
    json.Member("random", spec::HasDraw(value));
    WriteBounds(json, bounds);
    json.Key("choices");
    json.Raw(choices.value_or("null"));
  });
}

}  // namespace mjforge::customize
