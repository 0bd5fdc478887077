#ifndef MJFORGE_MANIFEST_PHYSICS_JSON_H_
#define MJFORGE_MANIFEST_PHYSICS_JSON_H_

// A record's `physics`.

#include <optional>

#include <rapidjson/document.h>

#include "mjforge/manifest/record_fields.h"
#include "mjforge/physics/physics.h"

namespace mjforge::manifest {

void WritePhysics(JsonText& json, const physics::Result& result);

/// Nothing if a member is missing or of the wrong kind.
std::optional<physics::Result> ReadPhysics(const rapidjson::Value& value);

}  // namespace mjforge::manifest

#endif  // MJFORGE_MANIFEST_PHYSICS_JSON_H_
