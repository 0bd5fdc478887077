// Tests that MuJoCo compiles the same meshes and textures from files as from inline assets.

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>

#include "harness/source_folder.h"
#include "mjforge/engine/engine.h"
#include "purity.h"

namespace mjforge::forge {
namespace {

engine::Model ModelOf(const Variant& variant) {
  engine::Engine engine;
  const auto problem = engine.SetAssets(variant.document.assets);
  INFO((problem ? problem->message : std::string()));
  REQUIRE_FALSE(problem);
  engine::Loaded loaded = engine.LoadText(variant.document.text);
  INFO(loaded.error);
  REQUIRE(loaded.model);
  return std::move(loaded.model);
}

// Returns the indices of vertex, normal and texture coordinate of a corner of a face; releases
// after 2.2 index them separately.
template <class M>
std::array<int, 3> IndicesOf(const M& m, int mesh, int corner) {
  const int vertex = m.mesh_face[corner];
  if constexpr (requires { m.mesh_facenormal; }) {
    return {vertex, m.mesh_normaladr[mesh] + m.mesh_facenormal[corner],
            m.mesh_texcoordadr[mesh] + m.mesh_facetexcoord[corner]};
  } else {
    return {vertex, m.mesh_vertadr[mesh] + vertex, m.mesh_texcoordadr[mesh] + vertex};
  }
}

// Corners of the faces of a mesh geom, in the frame of its body. Numbers of vertices cannot be
// compared, because MuJoCo 2.2 makes a vertex of each corner of an OBJ file.
struct Corners {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3d> normals;
  std::vector<Eigen::Vector2d> texcoords;  // empty, or one per corner

  Corners(const mjModel& m, int geom) {
    const int mesh = m.geom_dataid[geom];
    const mjtNum* q = m.geom_quat + 4 * geom;
    const Eigen::Quaterniond rotation(q[0], q[1], q[2], q[3]);
    const Eigen::Map<const Eigen::Vector3d> position(m.geom_pos + 3 * geom);
    using Single = Eigen::Map<const Eigen::Vector3f>;
    for (int i = 0; i < 3 * m.mesh_facenum[mesh]; ++i) {
      const auto [v, n, t] = IndicesOf(m, mesh, 3 * m.mesh_faceadr[mesh] + i);
      const Single vertex(m.mesh_vert + 3 * (m.mesh_vertadr[mesh] + v));
      vertices.emplace_back(rotation * vertex.cast<double>() + position);
      const Single normal(m.mesh_normal + 3 * n);
      normals.emplace_back(rotation * normal.cast<double>());
      if (m.mesh_texcoordadr[mesh] < 0) continue;
      texcoords.emplace_back(m.mesh_texcoord[2 * t], m.mesh_texcoord[2 * t + 1]);
    }
  }
};

template <typename Vector>
double Largest(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

// Returns the largest distance from a point of `a` to the nearest point of `b`.
double DirectedHausdorff(const std::vector<Eigen::Vector3d>& a,
                         const std::vector<Eigen::Vector3d>& b) {
  double farthest = 0;
  for (const Eigen::Vector3d& point : a) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& other : b) nearest = std::min(nearest, (point - other).norm());
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

double Largest(const mjtNum* a, const mjtNum* b, int count) {
  double largest = 0;
  for (int i = 0; i < count; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// Returns true if the text has the element, with this attribute.
bool HasAttribute(const std::string& text, const std::string& tag, const std::string& name,
                  const std::string& attribute) {
  const std::size_t element = text.find("<" + tag + " name=\"" + name + '"');
  return text.substr(element, text.find('\n', element) - element).find(attribute) != text.npos;
}

void CompareMeshes(const mjModel& a, const mjModel& b, const std::string& text) {
  for (int geom = 0; geom < a.ngeom; ++geom) {
    REQUIRE(a.geom_type[geom] == b.geom_type[geom]);
    if (a.geom_type[geom] != mjGEOM_MESH) continue;
    const std::string mesh = a.names + a.name_meshadr[a.geom_dataid[geom]];
    INFO("geom " << a.names + a.name_geomadr[geom] << " with mesh " << mesh);
    const Corners ours(a, geom);
    const Corners theirs(b, geom);
    if (!HasAttribute(text, "mesh", mesh, " face=") ||
        HasAttribute(text, "mesh", mesh, "scale=\"-")) {
      // MuJoCo triangulates hulls itself, and before 4.0 leaves the faces of a mirrored inline mesh
      // inside out. Compare only the vertices.
      CHECK(DirectedHausdorff(ours.vertices, theirs.vertices) < 1e-6);
      CHECK(DirectedHausdorff(theirs.vertices, ours.vertices) < 1e-6);
      continue;
    }
    CHECK(Largest(ours.vertices, theirs.vertices) < 1e-6);
    // OBJ counts v from the opposite edge; 1 - (1 - v) has an error in single precision.
    CHECK(Largest(ours.texcoords, theirs.texcoords) < 2e-6);
    if (HasAttribute(text, "mesh", mesh, " normal="))
      CHECK(Largest(ours.normals, theirs.normals) < 1e-5);
  }
}

void CompareTextures(const mjModel& a, const mjModel& b, const std::string& text) {
  REQUIRE(a.ntex == b.ntex);
  for (int i = 0; i < a.ntex; ++i) {
    const std::string name = a.names + a.name_texadr[i];
    INFO("texture " << name);
    CHECK(a.tex_width[i] == b.tex_width[i]);
    CHECK(a.tex_height[i] == b.tex_height[i]);
    // Random marks differ between releases of MuJoCo.
    if (!HasAttribute(text, "texture", name, "mark=\"random\""))
      CHECK(std::ranges::equal(engine::PixelsOf(a, i), engine::PixelsOf(b, i)));
  }
}

// Returns the number of meshes and textures in files.
int CompareForms(Loaded& loaded, Options options, std::uint64_t count) {
  Generator generator(loaded.recipe, loaded.sources, options);
  options.assets = mjcf::AssetForm::kFiles;
  Generator with_files(loaded.recipe, loaded.sources, options);
  int files = 0;
  for (std::uint64_t index = 0; index < count; ++index) {
    INFO(loaded.recipe.reference << ", index " << index);
    Variant inline_one;
    Variant filed;
    generator.Make(index, inline_one);
    with_files.Make(index, filed);
    REQUIRE(filed.ok() == inline_one.ok());
    if (!filed.ok()) continue;
    CHECK(filed.document.text.find(" vertex=") == std::string::npos);
    CHECK(filed.document.text.find(" builtin=\"flat") == std::string::npos);
    CHECK(filed.document.origins.size() == inline_one.document.origins.size());
    const engine::Model a = ModelOf(filed);
    const engine::Model b = ModelOf(inline_one);
    REQUIRE(a->nbody == b->nbody);
    CHECK(Largest(a->body_mass, b->body_mass, a->nbody) < 1e-12);
    CHECK(Largest(a->body_inertia, b->body_inertia, 3 * a->nbody) < 1e-12);
    CompareMeshes(*a, *b, inline_one.document.text);
    CompareTextures(*a, *b, inline_one.document.text);
    files += static_cast<int>(filed.document.assets.size());
  }
  return files;
}

TEST_CASE("every bundled spec compiles to the same with its meshes and textures in files") {
  int files = 0;
  for (const auto& spec : BundledSpecs()) {
    if (spec.parent_path().filename() == "scenes") continue;  // of objects of the other specs
    Loaded loaded(spec);
    Options options = Seeded(5);
    options.validation = Validation::kLoad;
    files += CompareForms(loaded, options, static_cast<std::uint64_t>(CasesOf(spec, 1)));
  }
  CHECK(files > 100);
}

TEST_CASE("convex meshes that MJX gets are files, too") {
  Loaded loaded(harness::SourceFolder() / "specs/robosuite/hammer.yaml");
  Options options = Seeded(5);
  options.validation = Validation::kLoad;
  options.target = mjcf::Target::kMjx;
  CHECK(CompareForms(loaded, options, 4) > 4);
}

TEST_CASE("inline meshes and patterns of an attached file become files") {
  const SpecFolder written;
  written.Write(
      "other.xml",
      "<mujoco><asset>\n"
      "<texture name='t' type='2d' builtin='checker' width='8' height='4'/>\n"
      "<material name='m' texture='t'/>\n"
      "<mesh name='hull' vertex='0 0 0  1 0 0  0 1 0  0 0 1  .1 .1 .1' scale='.1 .2 .3'/>\n"
      "<mesh name='soft' vertex='0 0 0  1 0 0  0 1 0  0 0 1' refpos='.1 0 0'\n"
      "  face='0 2 1  0 3 2  0 1 3  1 2 3' scale='-.1 .1 .1' smoothnormal='true'/>\n"
      "</asset><worldbody><body name='b'>\n"
      "<geom type='mesh' mesh='hull' material='m'/>\n"
      "<geom type='mesh' mesh='soft' pos='.2 0 0'/></body></worldbody></mujoco>\n");
  Loaded loaded = written.Load(
      "mjforge: 1\nname: outer\nbodies: [{name: one, mjcf: other.xml},\n"
      "  {name: two, mjcf: other.xml, pos: [1, 0, 0]}]\n");
  Options options = Seeded(1);
  options.validation = Validation::kLoad;
  CHECK(CompareForms(loaded, options, 1) == 3);
}

TEST_CASE("asset files are pure") {
  for (const auto& spec : BundledSpecs()) {
    Loaded loaded(spec);
    Options options = Seeded(6);
    options.assets = mjcf::AssetForm::kFiles;
    ComparePure(loaded, options, 0, CasesOf(spec, 6));
  }
}

}  // namespace
}  // namespace mjforge::forge
