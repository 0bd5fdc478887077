#pragma once

// The content of mesh files, unscaled.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/model/meshes.h"

namespace mjforge::model {

struct MeshFile {
  TriangleMesh mesh;
  /// MuJoCo 2.2 reads the same surface from the file: it does not read text STL, and of an OBJ it
  /// reads only the first shape, with faces of three or four corners.
  bool fit_for_mujoco = true;
};

/// On failure returns nothing and says why.
/// `unreadable`: whether the file itself could not be read, whatever is in it.
std::optional<MeshFile> ReadMeshFile(const std::filesystem::path& file, std::string& why_not,
                                     bool& unreadable);

/// The parsers, for texts in memory.
std::optional<MeshFile> ParseObj(std::string_view content, std::string& why_not);
std::optional<MeshFile> ParseStl(std::string_view content, std::string& why_not);

/// A copy with each coordinate times `scale` (no component zero).
TriangleMesh Scaled(const TriangleMesh& mesh, const Eigen::Vector3d& scale);

}  // namespace mjforge::model
