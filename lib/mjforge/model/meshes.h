#pragma once

// Triangle meshes: read from OBJ and STL.

#include <filesystem>
#include <optional>
#include <string>

#include <Eigen/Dense>

#include "mjforge/solid/solid.h"

namespace mjforge::model {

using solid::TriangleMesh;

/// Reads a .obj or .stl file (by its ending, any case), each coordinate times
/// `scale`; equal vertices are merged; a mirroring scale turns the triangles so
/// that they still face outwards. On failure says why.
std::optional<TriangleMesh> ReadMesh(const std::filesystem::path& file,
                                     const Eigen::Vector3d& scale, std::string& why_not);

/// Why the mesh has no well-defined inside ("edge shared by 1 triangle", "inside
/// out"), or nothing if it is closed, consistently oriented and of positive volume.
std::optional<std::string> WhyNotSolid(const TriangleMesh& mesh);

}  // namespace mjforge::model
