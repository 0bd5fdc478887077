// The physics result of a record: its schema, writing and reading.

#pragma once

#include <string>

#include "mjforge/manifest/record_values.h"
#include "mjforge/physics/physics.h"

namespace mjforge::manifest {

/// Returns the properties of a physics result, for a JSON Schema.
std::string ResultSchema();
void PutResult(Json& json, const physics::Result& result);
/// Reads a physics result from JSON. Returns the expected kind if `value` is not a physics result.
ExpectedKind GetResult(const rapidjson::Value& value, physics::Result& result);

}  // namespace mjforge::manifest
