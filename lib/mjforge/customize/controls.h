// Descriptions of the controls on the page of `mjforge customize`, one for each parameter of a
// spec.

#pragma once

#include "mjforge/diag/diag.h"
#include "mjforge/spec/spec.h"

namespace mjforge::customize {

/// Writes a list with an object for each parameter, with the members name, group, unit, doc, spec
/// (the value as written), kind, components, whole, random, low, high and choices. `kind` is
/// number, choice, switch, color, vector, text or list; or fixed for a column of a record, whose
/// value cannot be set because the record's key determines it. `low` and `high` are lists with a
/// number for each component, or null if the spec alone does not determine the bounds.
void WriteControls(diag::Json& json, const spec::ObjectSpec& spec);

}  // namespace mjforge::customize
