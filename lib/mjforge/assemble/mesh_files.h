// Readers of mesh files, OBJ and STL.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// The unscaled content of a mesh file. Equal vertices are merged.
struct MeshFile {
  model::TriangleMesh mesh;
  /// True if MuJoCo 2.2 reads the same surface from the file. MuJoCo rejects text STL, and of an
  /// OBJ reads only the first shape, with faces of three or four corners.
  bool fit_for_mujoco = true;
};

/// Reads a .obj or .stl file (the case of the ending does not matter). On failure returns nullopt
/// and sets `why_not`; `unreadable` is true if the file itself could not be read.
std::optional<MeshFile> ReadMeshFile(const std::filesystem::path& file, std::string& why_not,
                                     bool& unreadable);

/// Parses the content of a file. On failure, each function returns nullopt and sets `why_not`.
std::optional<MeshFile> ParseObj(std::string_view content, std::string& why_not);
std::optional<MeshFile> ParseStl(std::string_view content, std::string& why_not);

/// Returns a copy with scaled coordinates. A mirroring scale also reverses the triangles, so that
/// they still face outwards. No component of `scale` may be zero.
model::TriangleMesh Scaled(const model::TriangleMesh& mesh, const Eigen::Vector3d& scale);

}  // namespace mjforge::assemble
