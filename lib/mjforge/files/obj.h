#pragma once

#include <optional>
#include <string>

#include "mjforge/model/model.h"

namespace mjforge::files {

/// The mesh as a file of Wavefront OBJ, in m: what its element says inline, with the same digits,
/// and faces, which a convex hull does not say there. Nothing, and why, if it has no hull.
std::optional<std::string> ObjOf(const model::MeshAsset& asset, std::string& why_not);

}  // namespace mjforge::files
