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

/// Returns drawn values of the colour parameters (ColorsOf) as HexColor, by the parameter's name.
/// The values are those of some of the variants that the page shows. Returns an empty map if the
/// spec of the batch was not loaded.
std::map<std::string, std::vector<std::string>> DrawnColors(const Batch& batch);

}  // namespace mjforge::report
