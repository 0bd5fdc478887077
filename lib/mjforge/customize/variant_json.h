// Description of a variant as JSON for the page of `mjforge customize`.

#pragma once

#include "mjforge/customize/variant_cache.h"
#include "mjforge/diag/diag.h"

namespace mjforge::customize {

/// Writes three members: `values` of the parameters; `facts`, which are mass (kg), size (m) and
/// counts, or null if there is no object; and `joints`, a list of the hinges and slides.
void WriteVariant(diag::Json& json, const ShownVariant& shown);

/// Writes members about the part to which the geom `geom` belongs: `part` (its name), `material`,
/// `mass` (kg, of the whole shape if the part is a piece of one), `file` and `line` in the spec.
/// Writes no members if there is no such part. The variant must have an object.
void WritePart(diag::Json& json, const ShownVariant& shown, std::string_view geom);

}  // namespace mjforge::customize
