// Conversion of inline MJCF meshes to the OBJ format.

#include "mjforge/files/obj.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/expr/expr.h"
#include "mjforge/solid/solid.h"

namespace mjforge::files {
namespace {

// Mesh with flat lists of coordinates: 3 per vertex, 3 per normal and 2 per texture coordinate.
struct ObjMesh {
  std::vector<double> vertices;
  std::vector<double> normals;
  std::vector<double> texcoords;
  std::vector<std::array<int, 3>> triangles;
};

template <typename Vector>
std::vector<double> Flat(const std::vector<Vector>& vectors) {
  std::vector<double> numbers;
  for (const Vector& vector : vectors) numbers.insert(numbers.end(), vector.begin(), vector.end());
  return numbers;
}

std::vector<double> NumbersOf(const model::MeshAsset& asset, std::string_view name) {
  const model::Attribute* found = model::FindAttribute(asset.attributes, name);
  if (found == nullptr) return {};
  return {found->numbers.begin(), found->numbers.end()};
}

// Returns the triangles of the convex hull of points (`numbers`: x, y, z of each), because MuJoCo
// uses the hull for a mesh without faces. Sets `why_not` if there is no hull.
std::vector<std::array<int, 3>> HullOf(const std::vector<double>& numbers, std::string& why_not) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  solid::Fault fault;
  const std::optional<solid::Solid> hull = solid::Make(
      solid::ConvexHull{.points = points, .texture = {.unit = solid::TextureMapping::Unit::kNone}},
      fault);
  if (!hull) {
    why_not = fault.message;
    return {};
  }
  const solid::TriangleMesh& mesh = hull->pieces.front().mesh;
  std::vector<int> numbers_of;
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    numbers_of.push_back(static_cast<int>(std::ranges::find(points, vertex) - points.begin()));
  std::vector<std::array<int, 3>> triangles = mesh.triangles;
  for (std::array<int, 3>& triangle : triangles) {
    for (int& corner : triangle) corner = numbers_of[static_cast<std::size_t>(corner)];
  }
  return triangles;
}

// Reads the mesh from the attributes of a mesh element of an attached file (`vertex`, `face` and
// others), or from MeshAsset::mesh if the asset has no attribute `vertex`.
ObjMesh MeshOf(const model::MeshAsset& asset, std::string& why_not) {
  ObjMesh mesh = {
      NumbersOf(asset, "vertex"), NumbersOf(asset, "normal"), NumbersOf(asset, "texcoord"), {}};
  if (mesh.vertices.empty()) {
    return {Flat(asset.mesh.vertices), Flat(asset.mesh.normals), Flat(asset.mesh.texcoords),
            asset.mesh.triangles};
  }
  const std::vector<double> face = NumbersOf(asset, "face");
  for (std::size_t i = 0; i + 2 < face.size(); i += 3) {
    mesh.triangles.push_back(
        {static_cast<int>(face[i]), static_cast<int>(face[i + 1]), static_cast<int>(face[i + 2])});
  }
  if (face.empty()) mesh.triangles = HullOf(mesh.vertices, why_not);
  return mesh;
}

void AppendRows(std::string_view word, std::span<const double> numbers, std::size_t per_row,
                std::string& out) {
  for (std::size_t i = 0; i + per_row <= numbers.size(); i += per_row) {
    out += word;
    for (const double number : numbers.subspan(i, per_row)) {
      out += ' ';
      expr::AppendNumber(out, number);
    }
    out += '\n';
  }
}

}  // namespace

std::optional<std::string> ObjOf(const model::MeshAsset& asset, std::string& why_not) {
  ObjMesh mesh = MeshOf(asset, why_not);
  if (mesh.triangles.empty()) return std::nullopt;
  // Texture coordinate v is 0 at the lower edge of the image in OBJ, at the upper edge in MJCF.
  // MuJoCo flips v when it reads OBJ.
  for (std::size_t i = 1; i < mesh.texcoords.size(); i += 2)
    mesh.texcoords[i] = 1 - mesh.texcoords[i];
  std::string out;
  AppendRows("v", mesh.vertices, 3, out);
  AppendRows("vt", mesh.texcoords, 2, out);
  AppendRows("vn", mesh.normals, 3, out);
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    out += 'f';
    for (const int corner : triangle) {
      const std::string number = std::to_string(corner + 1);
      out.append(" ").append(number);
      if (!mesh.texcoords.empty()) out.append("/").append(number);
      if (!mesh.normals.empty()) out.append(mesh.texcoords.empty() ? "//" : "/").append(number);
    }
    out += '\n';
  }
  return out;
}

}  // namespace mjforge::files
