// Parameters that are colours, and their values as colours of a page.

#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mjforge/report/page_sections.h"

namespace mjforge::report {

/// Returns the names of the parameters that are drawn as hue, saturation and value, or that a
/// material, a texture, a part or a site has as its colour.
std::set<std::string> ColorsOf(const spec::ObjectSpec& spec);

/// Returns "#rrggbb" for 3 numbers from 0 to 1, "#rrggbbaa" for 4; nullopt for any other value.
std::optional<std::string> HexColor(const sample::ParameterValue& value);

/// Returns the values of the colours as HexColor, by the parameters' names, in some of the variants
/// that the page shows. Empty without a recipe.
std::map<std::string, std::vector<std::string>> DrawnColors(const Batch& batch);

}  // namespace mjforge::report
