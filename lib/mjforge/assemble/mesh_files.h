// Readers of mesh files in the formats OBJ and STL.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// The content of a mesh file, not scaled. Equal vertices are merged.
struct MeshFile {
  model::TriangleMesh mesh;
  /// True if MuJoCo 2.2 reads the same surface from the file. MuJoCo 2.2 rejects text STL. From an
  /// OBJ file, MuJoCo 2.2 reads only the first shape, and only faces with three or four corners.
  bool fit_for_mujoco = true;
};

/// Reads a .obj or .stl file; the case of the extension does not matter. On failure, returns
/// nullopt and sets `why_not`. Sets `unreadable` to true if the file itself cannot be read.
std::optional<MeshFile> ReadMeshFile(const std::filesystem::path& file, std::string& why_not,
                                     bool& unreadable);

/// Parses the content of an OBJ or STL file. On failure, returns nullopt and sets `why_not`.
std::optional<MeshFile> ParseObj(std::string_view content, std::string& why_not);
std::optional<MeshFile> ParseStl(std::string_view content, std::string& why_not);

/// Returns a copy with scaled coordinates. A mirroring scale also reverses the triangles, so that
/// they still face outwards. No component of `scale` may be zero.
model::TriangleMesh Scaled(const model::TriangleMesh& mesh, const Eigen::Vector3d& scale);

}  // namespace mjforge::assemble
