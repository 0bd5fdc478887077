#pragma once

// Triangle meshes: read from OBJ and STL, made from a convex polygon.

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Dense>

namespace mjforge::model {

/// A surface of triangles, counter-clockwise seen from outside. m.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
  std::vector<Eigen::Vector3d> normals = {};    // none, or for each vertex, of length 1
  std::vector<Eigen::Vector2d> texcoords = {};  // none, or for each vertex
  bool in_micrometres = false;                  // all vertices are at whole ones
};

/// The prism over a convex polygon (x, y pairs, in either direction; neighbouring corners may lie
/// on one line), centred on z = 0 with full height `height` > 0. On failure returns nothing and
/// says why ("polygon is not convex at corner 3", "polygon needs at least 3 corners", "polygon has
/// no area").
std::optional<TriangleMesh> MakePrism(std::span<const double> polygon, double height,
                                      std::string& why_not);

/// Reads a .obj or .stl file (by its ending, any case), each coordinate times
/// `scale`; equal vertices are merged; a mirroring scale turns the triangles so
/// that they still face outwards. On failure says why.
std::optional<TriangleMesh> ReadMesh(const std::filesystem::path& file,
                                     const Eigen::Vector3d& scale, std::string& why_not);

/// Why the mesh has no well-defined inside ("edge shared by 1 triangle", "inside
/// out"), or nothing if it is closed, consistently oriented and of positive volume.
std::optional<std::string> WhyNotSolid(const TriangleMesh& mesh);

}  // namespace mjforge::model
