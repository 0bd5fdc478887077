// Description of a spec's parameters as JSON: type, distribution, bounds and choices.
#include "parameters_json.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace mjforge::python {
namespace {

using spec::Bounds;
using spec::Value;

// Writes a number. Python's reader of JSON accepts Infinity, which is not part of JSON.
void WriteNumber(diag::Json& json, double number) {
  if (std::isfinite(number)) {
    json.Value(number);
  } else {
    json.Raw(number > 0 ? "Infinity" : "-Infinity");
  }
}

void WriteBounds(diag::Json& json, const Value& value) {
  const std::optional<Bounds> bounds = value.components == 1 ? spec::BoundsOf(value) : std::nullopt;
  const std::vector<Bounds> components = spec::BoundsOfComponents(value);
  for (const bool is_low : {true, false}) {
    json.Key(is_low ? "low" : "high");
    if (bounds) {
      WriteNumber(json, is_low ? bounds->low : bounds->high);
    } else if (components.empty()) {
      json.Value(nullptr);
    } else {
      json.List(components,
                [&](const Bounds& each) { WriteNumber(json, is_low ? each.low : each.high); });
    }
  }
}

// Writes the name of the distribution from which a value is drawn; null if the value is not a draw
// itself (an expression, for example).
void WriteDistribution(diag::Json& json, const Value& value) {
  const auto* draw = std::get_if<spec::Draw>(&value.form);
  if (draw == nullptr) return json.Value(nullptr);
  json.Value(
      std::ranges::find(spec::Distributions(), draw->distribution, &spec::DistributionInfo::id)
          ->key);
}

std::string_view TypeName(const Value& value) {
  return value.type == expr::Type::kNumber ? "number"
         : value.type == expr::Type::kText ? "text"
                                           : "boolean";
}

}  // namespace

void WriteParameters(diag::Json& json, const spec::ObjectSpec& spec) {
  json.Each(spec.parameters, [&](const spec::Parameter& parameter) {
    json.Member("name", parameter.name);
    json.Member("unit", parameter.unit);
    json.Member("section", parameter.section);
    json.Member("doc", parameter.doc);
    json.Member("spec", parameter.source);
    json.Member("type", TypeName(parameter.value));
    json.Member("components", parameter.value.is_list ? 0 : parameter.value.components);
    json.Key("distribution");
    WriteDistribution(json, parameter.value);
    json.Key("distributions");
    json.StartArray();
    if (const auto* list = std::get_if<spec::List>(&parameter.value.form);
        list != nullptr && !parameter.value.is_list) {
      for (const Value& item : list->items) WriteDistribution(json, item);
    }
    json.EndArray();
    WriteBounds(json, parameter.value);
    json.Key("choices");
    json.Raw(spec::ConstantChoices(parameter.value).value_or("null"));
  });
}

}  // namespace mjforge::python
