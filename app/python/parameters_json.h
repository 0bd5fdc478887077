// Description of a spec's parameters as JSON.
#pragma once

#include "mjforge/diag/diag.h"
#include "mjforge/spec/spec.h"

namespace mjforge::python {

/// Writes a list of objects with the members name, unit, section, doc, spec (the value as written),
/// type, components (0 for a list), distribution, distributions (of a vector's components), low,
/// high and choices. `low` and `high` are numbers, or lists for vectors. A member is null if it
/// does not apply to the parameter, or if only a variant determines its value.
void WriteParameters(diag::Json& json, const spec::ObjectSpec& spec);

}  // namespace mjforge::python
