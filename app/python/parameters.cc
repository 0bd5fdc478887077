// Description of a spec's parameters: type, distribution, bounds and choices.
#include "parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace mjforge::python {
namespace {

using spec::Distribution;
using spec::Value;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Bounds {
  double low = 0;
  double high = 0;
};

std::optional<Bounds> BoundsOf(const Value& value);

// Returns bounds from two constants; nothing if one of them depends on the variant.
std::optional<Bounds> Between(const Value& low, const Value& high) {
  const auto from = spec::ConstantOf(low);
  const auto to = spec::ConstantOf(high);
  if (!from || !to) return std::nullopt;
  return Bounds{*from, *to};
}

// Returns the bounds of all options of a choice.
std::optional<Bounds> Around(const std::vector<Value>& options) {
  std::optional<Bounds> all;
  for (const Value& option : options) {
    const std::optional<Bounds> bounds = BoundsOf(option);
    if (!bounds) return std::nullopt;
    if (!all) all = bounds;
    all->low = std::min(all->low, bounds->low);
    all->high = std::max(all->high, bounds->high);
  }
  return all;
}

std::optional<Bounds> BoundsOf(const spec::Draw& draw) {
  if (draw.limits.size() == 2) return Between(draw.limits[0], draw.limits[1]);
  switch (draw.distribution) {
    case Distribution::kUniform:
    case Distribution::kLogUniform:
    case Distribution::kTriangular:
    case Distribution::kInteger:
      return Between(draw.arguments.front(), draw.arguments.back());
    case Distribution::kNormal:
      return Bounds{-kInfinity, kInfinity};
    case Distribution::kLogNormal:
    case Distribution::kExponential:
    case Distribution::kPoisson:
      return Bounds{0, kInfinity};
    case Distribution::kBeta:
      return Bounds{0, 1};
    case Distribution::kChoice:
    case Distribution::kCycle:
      return Around(draw.arguments);
    case Distribution::kBernoulli:
      return std::nullopt;
  }
  return std::nullopt;
}

// Returns the bounds of a number; nothing for other types, and for numbers that depend on others.
std::optional<Bounds> BoundsOf(const Value& value) {
  if (value.type != expr::Type::kNumber || value.is_list) return std::nullopt;
  if (const auto* draw = std::get_if<spec::Draw>(&value.form)) return BoundsOf(*draw);
  const std::optional<double> number = spec::ConstantOf(value);
  if (!number) return std::nullopt;
  return Bounds{*number, *number};
}

// Returns the bounds of each component of a vector; none if one of them has no bounds.
std::vector<Bounds> BoundsOfComponents(const Value& value) {
  std::vector<Bounds> all;
  const auto* list = std::get_if<spec::List>(&value.form);
  if (list == nullptr || value.is_list) return {};
  for (const Value& item : list->items) {
    const std::optional<Bounds> bounds = BoundsOf(item);
    if (!bounds) return {};
    all.push_back(*bounds);
  }
  return all;
}

// Writes a number; Python's reader of JSON knows the word Infinity.
void WriteNumber(diag::Json& json, double number) {
  if (std::isfinite(number)) {
    json.Value(number);
  } else {
    json.Raw(number > 0 ? "Infinity" : "-Infinity");
  }
}

void WriteBounds(diag::Json& json, const Value& value) {
  const std::optional<Bounds> bounds = value.components == 1 ? BoundsOf(value) : std::nullopt;
  const std::vector<Bounds> components = BoundsOfComponents(value);
  for (const bool is_low : {true, false}) {
    json.Key(is_low ? "low" : "high");
    if (bounds) {
      WriteNumber(json, is_low ? bounds->low : bounds->high);
    } else if (components.empty()) {
      json.Value(nullptr);
    } else {
      json.StartArray();
      for (const Bounds& each : components) WriteNumber(json, is_low ? each.low : each.high);
      json.EndArray();
    }
  }
}

// Writes a value that is the same in all variants; returns false for any other.
bool WriteConstant(diag::Json& json, const Value& value) {
  if (const auto number = spec::ConstantOf(value)) {
    json.Value(*number);
  } else if (const auto text = spec::LiteralText(value)) {
    json.Value(*text);
  } else if (const auto* flag = std::get_if<bool>(&value.form)) {
    json.Value(*flag);
  } else if (const auto* list = std::get_if<spec::List>(&value.form)) {
    json.StartArray();
    for (const Value& item : list->items) {
      if (!WriteConstant(json, item)) return false;
    }
    json.EndArray();
  } else {
    return false;
  }
  return true;
}

void WriteChoices(diag::Json& json, const spec::Draw& draw) {
  json.Key("choices");
  diag::Json choices(expr::AppendExactNumber);
  choices.StartArray();
  const bool has_list =
      draw.distribution == Distribution::kChoice || draw.distribution == Distribution::kCycle;
  const bool is_constant = std::ranges::all_of(
      draw.arguments, [&](const Value& option) { return WriteConstant(choices, option); });
  choices.EndArray();
  json.Raw(has_list && is_constant ? choices.Take() : "null");
}

std::string_view TypeName(const Value& value) {
  return value.type == expr::Type::kNumber ? "number"
         : value.type == expr::Type::kText ? "text"
                                           : "boolean";
}

}  // namespace

void WriteParameters(diag::Json& json, const spec::ObjectSpec& spec) {
  json.StartArray();
  for (const spec::Parameter& parameter : spec.parameters) {
    json.StartObject();
    json.Member("name", parameter.name);
    json.Member("unit", parameter.unit);
    json.Member("doc", parameter.doc);
    json.Member("spec", parameter.source);
    json.Member("type", TypeName(parameter.value));
    json.Member("components", parameter.value.is_list ? 0 : parameter.value.components);
    const auto* draw = std::get_if<spec::Draw>(&parameter.value.form);
    json.Key("distribution");
    if (draw == nullptr) {
      json.Value(nullptr);
    } else {
      json.Value(
          std::ranges::find(spec::Distributions(), draw->distribution, &spec::DistributionInfo::id)
              ->key);
    }
    WriteBounds(json, parameter.value);
    WriteChoices(json, draw == nullptr ? spec::Draw() : *draw);
    json.EndObject();
  }
  json.EndArray();
}

}  // namespace mjforge::python
