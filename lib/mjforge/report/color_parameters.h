// Parameters whose values are colours, and these colours in the notation of HTML.

#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "mjforge/report/page_sections.h"

namespace mjforge::report {

/// Returns the names of the parameters that are colours: drawn as hue, saturation and value, or
/// used as the colour of a material, a texture, a part or a site.
std::set<std::string> ColorsOf(const spec::ObjectSpec& spec);

/// Returns "#rrggbb" for 3 numbers from 0 to 1, "#rrggbbaa" for 4; nullopt for any other value.
std::optional<std::string> HexColor(const sample::ParameterValue& value);

/// Returns drawn values of the colour parameters (ColorsOf) in the notation of HexColor(), by the
/// parameter's name. The values are those of up to 48 of the variants that the page shows. Returns
/// an empty map if the spec of the batch was not loaded.
std::map<std::string, std::vector<std::string>> DrawnColors(const Batch& batch);

}  // namespace mjforge::report
