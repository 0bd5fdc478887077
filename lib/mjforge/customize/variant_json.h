// Description of a variant as JSON for the page of `mjforge customize`.

#pragma once

#include "mjforge/customize/variant_cache.h"
#include "mjforge/diag/diag.h"

namespace mjforge::customize {

/// Writes three members: `values` of the parameters; `facts`, which are mass (kg), size (m) and
/// counts, or null if there is no object; and `joints`, a list of the movable joints.
void WriteVariant(diag::Json& json, const ShownVariant& shown);

/// Writes members about the part that has the geom `geom`: `part`, `material`, `mass` (kg, with all
/// pieces of the part), `file` and `line`. Writes no members if no part has this geom.
void WritePart(diag::Json& json, const ShownVariant& shown, std::string_view geom);

}  // namespace mjforge::customize
