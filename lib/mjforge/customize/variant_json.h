// Description of a variant as JSON for the page.

#pragma once

#include "mjforge/customize/variant_cache.h"
#include "mjforge/diag/diag.h"

namespace mjforge::customize {

/// Returns true for joints whose position is one number: hinges and slides.
bool IsMovable(const picture::Joint& joint);

/// Writes three members: `values` of the parameters; `facts`, which are mass (kg), size (m) and
/// counts, or null if there is no object; and `joints`, a list of those that are movable.
void WriteVariant(diag::Json& json, const ShownVariant& shown);

/// Writes members about the part of the spec whose geom has this name: `part`, `material`, `mass`
/// (kg, with all its pieces), `file` and `line`. Writes none if there is no such part.
void WritePart(diag::Json& json, const ShownVariant& shown, std::string_view geom);

}  // namespace mjforge::customize
