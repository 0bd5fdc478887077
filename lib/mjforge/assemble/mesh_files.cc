// Readers of OBJ (by tinyobjloader), binary STL and text STL.

#include "mjforge/assemble/mesh_files.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"
#include "mjforge/mesh_data/mesh_data.h"

namespace mjforge::assemble {
namespace {

struct VertexHash {
  std::size_t operator()(const Eigen::Vector3d& v) const {
    std::size_t hash = 0;
    for (const double x : v) hash = hash * 0x9E3779B97F4A7C15u + std::hash<double>()(x);
    return hash;
  }
};

// Builds a mesh from triangles given by their corners. Equal corners become one vertex, and
// triangles with two equal corners are left out.
class MeshBuilder {
 public:
  void Add(const std::array<Eigen::Vector3d, 3>& corners) {
    std::array<int, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      finite_ = finite_ && corners[i].allFinite();
      const auto [found, is_new] =
          numbers_.try_emplace(corners[i], static_cast<int>(mesh_.vertices.size()));
      if (is_new) mesh_.vertices.push_back(corners[i]);
      triangle[i] = found->second;
    }
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
      return;
    }
    mesh_.triangles.push_back(triangle);
  }

  std::optional<MeshFile> Finish(bool fit_for_mujoco, std::string& why_not) && {
    if (!finite_) {
      why_not = "a coordinate is not a finite number";
    } else if (mesh_.triangles.empty()) {
      why_not = "no triangles";
    } else {
      return MeshFile{std::move(mesh_), fit_for_mujoco};
    }
    return std::nullopt;
  }

 private:
  model::TriangleMesh mesh_;
  std::unordered_map<Eigen::Vector3d, int, VertexHash> numbers_;
  bool finite_ = true;
};

// Returns the first line of an error message.
std::string FirstLine(std::string_view text) {
  return std::string(text.substr(0, text.find_first_of("\r\n")));
}

// Counts of the faces in the text of an OBJ file.
struct Faces {
  std::size_t polygon = 0;    // line of the first face with more than 4 corners; 0 if there is none
  std::size_t triangles = 0;  // number of triangles into which all faces can be cut
};

Faces CountFaces(std::string_view content) {
  Faces faces;
  for (std::size_t number = 1; !content.empty(); ++number) {
    const std::vector<std::string_view> words = expr::WordsOf(diag::CutAt('\n', content));
    if (words.size() < 4 || words[0] != "f") continue;
    const std::size_t corners = words.size() - 1;
    if (corners > 4 && faces.polygon == 0) faces.polygon = number;
    faces.triangles += corners - 2;
  }
  return faces;
}

std::optional<MeshFile> BuildObj(const tinyobj::ObjReader& reader, const Faces& faces,
                                 std::string& why_not) {
  const std::vector<tinyobj::real_t>& numbers = reader.GetAttrib().vertices;
  const std::size_t vertex_count = numbers.size() / 3;
  MeshBuilder builder;
  std::size_t triangles = 0;
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    const std::vector<tinyobj::index_t>& indices = shape.mesh.indices;
    triangles += indices.size() / 3;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      std::array<Eigen::Vector3d, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto vertex = static_cast<std::size_t>(indices[i + k].vertex_index);
        if (indices[i + k].vertex_index < 0 || vertex >= vertex_count)
          return diag::Refuse(
              why_not, fmt::format("a face uses vertex {} of {}",
                                   std::ptrdiff_t{indices[i + k].vertex_index} + 1, vertex_count));
        corners[k] = {numbers[3 * vertex], numbers[3 * vertex + 1], numbers[3 * vertex + 2]};
      }
      builder.Add(corners);
    }
  }
  // tinyobjloader leaves out triangles of some faces that are not convex, or thin.
  if (faces.polygon > 0 && triangles < faces.triangles) {
    why_not = fmt::format(
        "a face with more than 4 corners (the first one is on line {}) is not "
        "convex or too thin; cut it into triangles",
        faces.polygon);
    return std::nullopt;
  }
  const bool is_plain = reader.GetShapes().size() == 1 && faces.polygon == 0;
  return std::move(builder).Finish(is_plain, why_not);
}

void AddBinaryStl(std::string_view content, MeshBuilder& builder) {
  static_assert(std::endian::native == std::endian::little);
  for (std::size_t at = mesh_data::kStlHeader; at < content.size(); at += mesh_data::kStlTriangle) {
    std::array<float, 12> numbers;  // normal and corners
    std::memcpy(numbers.data(), content.data() + at, sizeof(numbers));
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {numbers[3 * k + 3], numbers[3 * k + 4], numbers[3 * k + 5]};
    builder.Add(corners);
  }
}

// Returns the coordinates of a line `vertex X Y Z`, given as words, rounded to the precision of
// binary STL (float).
std::optional<Eigen::Vector3d> StlVertex(std::span<const std::string_view> words) {
  if (words.size() != 4) return std::nullopt;
  Eigen::Vector3d vertex;
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> number = expr::ParseNumber(words[static_cast<std::size_t>(i) + 1]);
    if (!number) return std::nullopt;
    vertex[i] = static_cast<float>(*number);
  }
  return vertex;
}

// Reads text STL line by line. Names of solids may contain any words, and normals are ignored.
// Returns false and sets `why_not` if a line is not valid in text STL.
bool AddTextStl(std::string_view content, MeshBuilder& builder, std::string& why_not) {
  constexpr std::string_view kIgnored[] = {"solid", "facet", "outer", "endfacet", "endsolid"};
  std::array<Eigen::Vector3d, 3> corners;
  std::size_t count = 0;  // corners of the current triangle
  bool is_begun = false;
  for (std::size_t number = 1; !content.empty(); ++number) {
    const std::vector<std::string_view> words = expr::WordsOf(diag::CutAt('\n', content));
    if (words.empty()) continue;
    is_begun |= words[0] == "solid";
    if (is_begun && std::ranges::count(kIgnored, words[0]) > 0) continue;
    const auto vertex = words[0] == "vertex" ? StlVertex(words) : std::nullopt;
    if (is_begun && vertex && count < 3) {
      corners[count++] = *vertex;
    } else if (words[0] == "endloop" && count == 3) {
      builder.Add(corners);
      count = 0;
    } else {
      why_not = is_begun ? fmt::format("line {} does not belong in an STL text", number)
                         : "neither a text nor a binary STL file";
      return false;
    }
  }
  if (count > 0) why_not = "it ends within a triangle";
  return count == 0;
}

// Returns the result of `parse`. If `parse` throws, returns nullopt and sets `why_not`.
template <typename Parse>
std::optional<MeshFile> CatchExceptions(Parse parse, std::string& why_not) {
  try {
    return parse();
  } catch (const std::bad_alloc&) {
    throw;  // not an error of the file
  } catch (const std::exception& error) {
    why_not = FirstLine(error.what());
  }
  return std::nullopt;
}

}  // namespace

std::optional<MeshFile> ParseObj(std::string_view content, std::string& why_not) {
  if (content.find('\0') != std::string_view::npos) return diag::Refuse(why_not, "not a text file");
  why_not = mesh_data::CheckFile(mesh_data::Format::kObj, content).fault;
  if (!why_not.empty()) return std::nullopt;
  const auto parse = [&]() -> std::optional<MeshFile> {
    tinyobj::ObjReader reader;
    tinyobj::ObjReaderConfig config;
    config.triangulate = true;
    config.vertex_color = false;
    if (reader.ParseFromString(std::string(content), std::string(), config))
      return BuildObj(reader, CountFaces(content), why_not);
    return diag::Refuse(why_not,
                        reader.Error().empty() ? "not an OBJ file" : FirstLine(reader.Error()));
  };
  return CatchExceptions(parse, why_not);
}

std::optional<MeshFile> ParseStl(std::string_view content, std::string& why_not) {
  const auto parse = [&]() -> std::optional<MeshFile> {
    MeshBuilder builder;
    const bool is_binary = mesh_data::IsBinaryStl(content);
    if (is_binary) {
      AddBinaryStl(content, builder);
    } else if (!AddTextStl(content, builder, why_not)) {
      return std::nullopt;
    }
    return std::move(builder).Finish(is_binary, why_not);
  };
  return CatchExceptions(parse, why_not);
}

std::optional<MeshFile> ReadMeshFile(const std::filesystem::path& file, std::string& why_not,
                                     bool& unreadable) {
  unreadable = false;
  const std::string ending = diag::LowerCase(file.extension().string());
  if (ending != ".obj" && ending != ".stl")
    return diag::Refuse(why_not, fmt::format("ending '{}' is neither .obj nor .stl", ending));
  const std::optional<std::string> content = bytes::Read(file, bytes::kMaxAsset, why_not);
  unreadable = !content;
  if (!content) return std::nullopt;
  if (content->empty()) return diag::Refuse(why_not, "empty file");
  return ending == ".obj" ? ParseObj(*content, why_not) : ParseStl(*content, why_not);
}

model::TriangleMesh Scaled(const model::TriangleMesh& mesh, const Eigen::Vector3d& scale) {
  model::TriangleMesh scaled = mesh;
  for (Eigen::Vector3d& vertex : scaled.vertices) vertex = vertex.cwiseProduct(scale);
  if (scale.prod() < 0) {
    for (auto& triangle : scaled.triangles) std::swap(triangle[1], triangle[2]);
  }
  return scaled;
}

}  // namespace mjforge::assemble
