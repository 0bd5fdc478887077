// Tests of the readers of OBJ and STL, with damaged and random files.

#include "mjforge/assemble/mesh_files.h"

#include <array>
#include <cstring>
#include <fstream>
#include <random>

#include <catch2/catch.hpp>

#include "mjforge/model/model.h"

namespace mjforge::assemble {
namespace {

constexpr std::string_view kTetrahedronObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

constexpr std::array<std::array<std::array<float, 3>, 3>, 4> kTetrahedronCorners = {{
    {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}},
    {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}},
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}}},
}};

std::string BinaryStl() {
  std::string stl(80, '\0');
  const auto append = [&stl](const auto& value) {
    stl.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  append(std::uint32_t{4});
  for (const auto& triangle : kTetrahedronCorners) {
    append(std::array<float, 3>{});
    append(triangle);
    append(std::uint16_t{0});
  }
  return stl;
}

std::string TextStl() {
  std::string stl = "solid tetra\n";
  for (const auto& triangle : kTetrahedronCorners) {
    stl += "facet normal 0 0 0\nouter loop\n";
    for (const auto& v : triangle) {
      stl += "vertex";
      for (const float x : v) stl += x != 0 ? " 1.0e0" : " 0";
      stl += "\n";
    }
    stl += "endloop\nendfacet\n";
  }
  return stl + "endsolid tetra\n";
}

void CheckTetrahedron(const std::optional<MeshFile>& file, const std::string& why_not) {
  INFO(why_not);
  REQUIRE(file);
  CHECK(file->mesh.vertices.size() == 4);
  CHECK(file->mesh.triangles.size() == 4);
  CHECK(model::FindSurfaceDefect(file->mesh) == std::nullopt);
  CHECK(model::Volume({.type = model::GeomType::kMesh, .mesh = &file->mesh}) == Approx(1 / 6.0));
}

class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, std::string_view content)
      : path_(std::filesystem::temp_directory_path() /
              ("mjforge_mesh_" + std::to_string(std::random_device()()) + name)) {
    std::ofstream(path_, std::ios::binary)
        .write(content.data(), static_cast<std::streamsize>(content.size()));
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

TEST_CASE("an OBJ file is read") {
  std::string why_not;
  const std::optional<MeshFile> file = ParseObj(kTetrahedronObj, why_not);
  CheckTetrahedron(file, why_not);
  CHECK(file->fit_for_mujoco);
}

TEST_CASE("binary and text STL give the same mesh") {
  std::string why_not;
  const std::optional<MeshFile> binary = ParseStl(BinaryStl(), why_not);
  CheckTetrahedron(binary, why_not);
  CHECK(binary->fit_for_mujoco);
  const std::optional<MeshFile> text = ParseStl(TextStl(), why_not);
  CheckTetrahedron(text, why_not);
  CHECK_FALSE(text->fit_for_mujoco);  // MuJoCo reads binary STL only
}

TEST_CASE("text STL is read whatever its solids are called and their normals are") {
  std::string text = TextStl();
  const auto replace = [&text](const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
      text.replace(at, from.size(), to);
  };
  replace("solid tetra", "solid  vertex of a facet");
  replace("normal 0 0 0", "normal nan nan nan");
  replace("\n", " \r\n\t");
  std::string why_not;
  CheckTetrahedron(ParseStl("\n" + text + "solid\nendsolid", why_not), why_not);
}

TEST_CASE("text STL that is something else is refused with its line") {
  const auto reason = [](std::string_view text) {
    std::string why_not;
    CHECK_FALSE(ParseStl(text, why_not));
    return why_not;
  };
  const std::string corner = "vertex 0 1 -2.5e-1\n";
  const std::string open = "solid a\nfacet normal 0 0 1\nouter loop\n" + corner + corner;
  CHECK(reason("facet normal 0 0 1\n") == "neither a text nor a binary STL file");
  CHECK(reason("solid a\nendsolid a\n") == "no triangles");
  CHECK(reason(open) == "it ends within a triangle");
  CHECK(reason(open + "endloop\n") == "line 6 does not belong in an STL text");
  CHECK(reason(open + corner + corner) == "line 7 does not belong in an STL text");
  CHECK(reason(open + "vertex 1 2\n") == "line 6 does not belong in an STL text");
  CHECK(reason(open + "vertex 1 2 x\n") == "line 6 does not belong in an STL text");
  CHECK(reason(open + "corner 1 2 3\n") == "line 6 does not belong in an STL text");
  CHECK(reason(open + "vertex 1 1 1e39\nendloop\n") == "a coordinate is not a finite number");
}

TEST_CASE("OBJ faces of many corners are cut into triangles, which MuJoCo cannot do") {
  std::string prism;
  for (const char* z : {"0", "1"}) {
    for (const char* xy : {"0 0", "2 0", "3 1", "2 2", "0 2"}) {
      prism += std::string("v ") + xy + " " + z + "\n";
    }
  }
  prism += "f 5 4 3 2 1\nf 6 7 8 9 10\nf 1 2 7 6\nf 2 3 8 7\nf 3 4 9 8\nf 4 5 10 9\nf 5 1 6 10\n";
  std::string why_not;
  const std::optional<MeshFile> file = ParseObj(prism, why_not);
  INFO(why_not);
  REQUIRE(file);
  CHECK(model::FindSurfaceDefect(file->mesh) == std::nullopt);
  CHECK(model::Volume({.type = model::GeomType::kMesh, .mesh = &file->mesh}) == Approx(5));
  CHECK_FALSE(file->fit_for_mujoco);
}

TEST_CASE("an OBJ file of several shapes is one mesh") {
  std::string why_not;
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
      "o a\nf 1 3 2\nf 1 2 4\no b\nf 2 3 4\nf 1 4 3\n";
  const std::optional<MeshFile> file = ParseObj(text, why_not);
  CheckTetrahedron(file, why_not);
  CHECK_FALSE(file->fit_for_mujoco);  // MuJoCo reads the first shape only
}

TEST_CASE("a mirroring scale leaves the triangles facing outwards") {
  const TemporaryFile file("tetra.OBJ", kTetrahedronObj);
  std::string why_not;
  bool unreadable = false;
  const std::optional<MeshFile> read = ReadMeshFile(file.path(), why_not, unreadable);
  INFO(why_not);
  REQUIRE(read);
  const model::TriangleMesh mesh = Scaled(read->mesh, {-1, 2, 3});
  CHECK(model::FindSurfaceDefect(mesh) == std::nullopt);
  CHECK(model::Volume({.type = model::GeomType::kMesh, .mesh = &mesh}) == Approx(1));
}

TEST_CASE("files that cannot be meshes are refused with a reason") {
  const auto reason = [](const std::filesystem::path& path) {
    std::string why_not;
    bool unreadable = false;
    CHECK_FALSE(ReadMeshFile(path, why_not, unreadable));
    return why_not;
  };
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  CHECK(reason(folder / "mjforge_nowhere.obj") == "No such file or directory");
  CHECK(reason(TemporaryFile("a.ply", "ply").path()) == "ending '.ply' is neither .obj nor .stl");
  CHECK(reason(TemporaryFile("empty.stl", "").path()) == "empty file");
  CHECK(reason(TemporaryFile("words.obj", "these are words\n").path()) == "no triangles");
  CHECK(reason(TemporaryFile("binary.obj", BinaryStl()).path()) == "not a text file");
  CHECK(reason(TemporaryFile("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n").path()) ==
        "line 4: a face uses vertex 9 of 3");
  CHECK(reason(TemporaryFile("wrap.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4294967299\n").path()) ==
        "line 4: a face uses vertex 4294967299 of 3");
  CHECK(reason(TemporaryFile("unused.obj", "v nan 0 0\n").path()) ==
        "line 1: 'nan' of a vertex is not a finite number");
}

TEST_CASE("a folder is not a mesh") {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("mjforge_folder_" + std::to_string(std::random_device()()) + ".obj");
  std::filesystem::create_directory(folder);
  std::string why_not;
  bool unreadable = false;
  CHECK_FALSE(ReadMeshFile(folder, why_not, unreadable));
  CHECK(unreadable);
  CHECK(why_not == "it is a folder");
  std::filesystem::remove(folder);
}

TEST_CASE("coordinates that are not finite are refused") {
  std::string stl = BinaryStl();
  const float bad = std::numeric_limits<float>::infinity();
  std::memcpy(stl.data() + 84 + 12, &bad, sizeof(bad));
  std::string why_not;
  CHECK_FALSE(ParseStl(stl, why_not));
  CHECK(why_not == "a coordinate is not a finite number");
}

// Neither parser may crash, or return a mesh with indices out of range.
void Survive(std::string_view content) {
  std::string why_not;
  for (const auto& parse : {ParseObj, ParseStl}) {
    const std::optional<MeshFile> file = parse(content, why_not);
    if (!file) continue;
    const int count = static_cast<int>(file->mesh.vertices.size());
    for (const auto& triangle : file->mesh.triangles) {
      for (const int vertex : triangle) REQUIRE((vertex >= 0 && vertex < count));
    }
  }
}

TEST_CASE("cut off, mangled and random files do no harm") {
  std::mt19937 random(20240601);
  for (const std::string& whole : {std::string(kTetrahedronObj), BinaryStl(), TextStl()}) {
    for (std::size_t length = 0; length < whole.size(); ++length) {
      Survive(std::string_view(whole).substr(0, length));
    }
    for (int i = 0; i < 500; ++i) {
      std::string mangled = whole;
      for (int k = 0; k < 5; ++k) {
        mangled[random() % mangled.size()] = static_cast<char>(random() % 256);
      }
      Survive(mangled);
    }
  }
  for (int i = 0; i < 200; ++i) {
    std::string noise(random() % 400, '\0');
    for (char& c : noise) c = static_cast<char>(random() % 256);
    Survive(noise);
  }
}

TEST_CASE("a polygon that is not convex is an error if it loses triangles") {
  // A box with a notch in its outline.
  const std::string vertices =
      "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nv 0 0 1\nv 2 0 1\nv 2 2 1\nv 1 0.5 1\n"
      "v 0 2 1\n";
  const std::string sides = "f 1 2 7 6\nf 2 3 8 7\nf 3 4 9 8\nf 4 5 10 9\nf 5 1 6 10\n";
  std::string why_not;
  CHECK_FALSE(ParseObj(vertices + sides + "f 5 4 3 2 1\nf 6 7 8 9 10\n", why_not));
  CHECK(why_not ==
        "a face with more than 4 corners (the first one is on line 16) is not convex or too thin; "
        "cut "
        "it into triangles");
  CHECK_FALSE(ParseObj(vertices + sides + "  f 5 4 3 2 1\nf 6 7 8 9 10\n", why_not));
  const std::string cut = "f 1 4 2\nf 2 4 3\nf 1 5 4\nf 6 7 9\nf 7 8 9\nf 6 9 10\n";
  const std::optional<MeshFile> file = ParseObj(vertices + sides + cut, why_not);
  REQUIRE(file);
  CHECK(file->mesh.triangles.size() == 16);
}

}  // namespace
}  // namespace mjforge::assemble
