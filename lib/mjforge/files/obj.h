// Conversion of a mesh to the text of a Wavefront OBJ file.

#pragma once

#include <optional>
#include <string>

#include "mjforge/model/model.h"

namespace mjforge::files {

/// Returns the mesh in the OBJ format, in m, with the same digits as in its MJCF element. A mesh
/// without faces gets the faces of its convex hull. Returns nullopt and sets `why_not` if this hull
/// does not exist.
std::optional<std::string> ObjOf(const model::MeshAsset& asset, std::string& why_not);

}  // namespace mjforge::files
