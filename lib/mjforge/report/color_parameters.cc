// Search for parameters of a spec that are colours, and conversion of their values for HTML.

#include "mjforge/report/color_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

namespace mjforge::report {
namespace {

void AddColors(std::span<const spec::Field> fields, std::set<std::string>& names) {
  constexpr std::array<std::string_view, 4> kColorKeys = {"rgba", "rgb1", "rgb2", "markrgb"};
  for (const spec::Field& field : fields) {
    if (std::ranges::find(kColorKeys, field.info->key) == kColorKeys.end()) continue;
    if (const auto* used = std::get_if<spec::VariableReference>(&field.value.form))
      names.insert(used->name);
  }
}

void AddColors(const std::vector<spec::Entry>& entries, std::set<std::string>& names) {
  for (const spec::Entry& entry : entries) {
    AddColors(entry.fields, names);
    AddColors(entry.children, names);
  }
}

}  // namespace

std::set<std::string> ColorsOf(const spec::ObjectSpec& spec) {
  std::set<std::string> names;
  for (const spec::Parameter& parameter : spec.parameters) {
    if (std::holds_alternative<spec::HsvColor>(parameter.value.form)) names.insert(parameter.name);
  }
  for (const spec::Material& material : spec.materials) {
    AddColors(material.fields, names);
    AddColors(material.texture, names);
  }
  AddColors(spec.parts, names);
  AddColors(spec.sites, names);
  for (const spec::BodyEntry& body : spec.bodies) {
    AddColors(body.parts, names);
    AddColors(body.sites, names);
  }
  return names;
}

std::optional<std::string> HexColor(const sample::ParameterValue& value) {
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  if (numbers == nullptr || numbers->size() < 3 || numbers->size() > 4) return std::nullopt;
  std::string color = "#";
  for (const double number : *numbers) {
    if (!(number >= 0 && number <= 1)) return std::nullopt;
    color += fmt::format("{:02x}", static_cast<int>(std::lround(255 * number)));
  }
  return color;
}

std::map<std::string, std::vector<std::string>> DrawnColors(const Batch& batch) {
  constexpr std::size_t kMost = 48;  // largest number of colours of a parameter
  std::map<std::string, std::vector<std::string>> drawn;
  if (!batch.recipe) return drawn;
  const std::set<std::string> names = ColorsOf(*batch.recipe->spec);
  if (names.empty()) return drawn;
  for (const ShownVariant& shown : batch.summary.Choose()) {
    for (const auto& [name, value] : shown.record.params) {
      if (!names.contains(name) || drawn[name].size() >= kMost) continue;
      if (const std::optional<std::string> color = HexColor(value)) drawn[name].push_back(*color);
    }
  }
  return drawn;
}

}  // namespace mjforge::report
