#pragma once

#include <filesystem>

#include "mjforge/model/assets.h"
#include "mjforge/model/field_reader.h"

namespace mjforge::model {

/// Sets the part's shape and the pose X_FG that its fields give it; false after
/// a finding.
bool ReadShape(FieldReader& reader, const spec::Entry& entry, const std::filesystem::path& folder,
               Assets& assets, Part& part, Pose& X_FG);

/// The type that a word of the field table names; prisms are meshes.
GeomType TypeOf(std::string_view word);

}  // namespace mjforge::model
