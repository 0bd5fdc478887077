// The physics result of a record: its schema, writing and reading.

#pragma once

#include <string>

#include "mjforge/manifest/record_values.h"
#include "mjforge/physics/physics.h"

namespace mjforge::manifest {

/// Returns the properties of a result, for a JSON Schema.
std::string ResultSchema();
void PutResult(Json& json, const physics::Result& result);
/// Replaces a result by that of a JSON value; returns the kind that was expected if it is none.
ExpectedKind GetResult(const rapidjson::Value& value, physics::Result& result);

}  // namespace mjforge::manifest
