// Checks of meshes and skins before MuJoCo reads them: indices of faces are in range, and numbers
// are finite.
//
// MuJoCo 2.2 reads memory outside of a mesh if an index is out of range, and wraps indices of OBJ
// files at 2^32. For a skin, MuJoCo reads memory outside of the skin when drawing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mjforge::mesh_data {

/// File formats of meshes and skins that MuJoCo reads. MSH and SKN are MuJoCo's own formats of
/// meshes and skins.
enum class Format { kObj, kStl, kMsh, kSkn };

/// Returns the format of a file by the last three letters of its name, like MuJoCo; nullopt if
/// MuJoCo does not read such a file as a mesh or skin.
std::optional<Format> FormatOf(std::string_view file_name);

/// Result of the check of a file.
struct Check {
  std::string fault;         // "line 8: a face uses vertex 9 of 4"; empty if there is none
  std::size_t vertices = 0;  // number of vertices in the file
};

/// Checks the content of a file. Returns a fault if an index is out of range or a number is not
/// finite as float, the type of MuJoCo's meshes. Returns no fault for content that is not in the
/// format at all, because MuJoCo rejects such content with a reason.
Check CheckFile(Format format, std::string_view content);

/// Sizes in binary STL, bytes: of the header, whose last four bytes are the number of triangles,
/// and of a triangle, which has twelve floats (normal and corners) and two unused bytes.
inline constexpr std::size_t kStlHeader = 84;
inline constexpr std::size_t kStlTriangle = 50;

/// Returns true if the size of the content matches the number of triangles in its header.
bool IsBinaryStl(std::string_view content);

/// Attributes of an MJCF element `mesh` or `skin`; empty if the element does not have them.
struct InlineMesh {
  std::string_view vertex = {};
  std::string_view normal = {};
  std::string_view texcoord = {};
  std::string_view face = {};
  std::size_t file_vertices = 0;  // number of vertices in the element's file, if it has one
};

/// Returns a message about the first number of `vertex`, `normal` and `texcoord` that is not finite
/// or, if all are finite, about the first index in `face` that is out of range. Returns an empty
/// text if the mesh has no fault.
std::string FindFault(const InlineMesh& mesh);

}  // namespace mjforge::mesh_data
