// Values that are the same in all variants, as JSON.
#pragma once

#include "mjforge/diag/diag.h"

namespace mjforge::spec {

struct Value;

/// Writes a number, text, boolean or list of these that is the same in all variants. Returns false
/// for any other value, after which the JSON may be incomplete.
bool WriteConstant(diag::Json& json, const Value& value);

}  // namespace mjforge::spec
