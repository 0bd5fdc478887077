// Meshes and textures of one object, and the parts whose shapes the library `solid` makes.

#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mjforge/assemble/assemble.h"
#include "mjforge/assemble/field_reader.h"
#include "mjforge/solid/solid.h"

namespace mjforge::assemble {

/// Returns the random stream of a material's fields.
inline sample::StreamId MaterialPath(const sample::Evaluator& values,
                                     const spec::Material& material) {
  return sample::Child(sample::Child(values.root(), "materials"), material.name);
}

/// Name of a shape's outline (the outer polygon or a hole), and positions of the outline's points
/// in the text of the spec, for findings.
struct OutlinePlace {
  std::string name = {};                     // "hole 1 along x"; empty for the outer outline
  std::vector<diag::SourceMark> marks = {};  // a mark per point of the outline; may be empty
};

/// A shape (lathe, prism, ...) that the library `solid` makes, and its positions in the text of the
/// spec, for findings.
struct SolidInput {
  const solid::SolidShape& shape;
  const spec::Field& field;  // field that contains the outer outline, the path or the size
  /// Outlines in the order of solid::Fault::loop: the outer outline, then the holes.
  const std::vector<OutlinePlace>& outlines;
};

/// Returns the `count` numbers of the field `scale`; all 1 if the entry does not have the field.
/// Returns nullopt, and adds a finding, if the field is invalid.
std::optional<sample::Numbers> ReadScale(FieldReader& reader, const spec::Entry& entry,
                                         std::size_t count);

/// Returns a required field. Returns null, and adds a finding, if the entry does not have the
/// field.
const spec::Field* Required(FieldReader& reader, const spec::Entry& entry, spec::Key id,
                            std::string_view key, diag::SourceMark mark);

/// Returns the first of the indices with this key in a multimap that meets a condition; nullopt if
/// there is none.
template <typename Map, typename Condition>
std::optional<int> FindIndex(const Map& indices, const typename Map::key_type& key,
                             const Condition& condition) {
  const auto [begin, end] = indices.equal_range(key);
  const auto found = std::find_if(begin, end, [&](const auto& pair) {
    return condition(static_cast<std::size_t>(pair.second));
  });
  return found == end ? std::nullopt : std::optional(found->second);
}

/// Adds meshes and textures to one object. Equal meshes and equal textures are added only once.
class Assets {
 public:
  Assets(Assembler& assembler, model::Object& object, diag::Findings& findings)
      : assembler_(assembler), object_(object), findings_(findings) {}

  /// Sets the folder of the object's spec; see OutputName. `folder` must outlive this object.
  void SetFolder(const std::filesystem::path& folder) { folder_ = &folder; }
  /// Makes a shape with the library `solid`. Sets the part's render mesh (unless the part only
  /// collides) and the part's exact mass properties. Returns the colliding convex pieces, with
  /// poses in the part's frame. If the shape is a single convex mesh, sets this mesh, and returns
  /// no pieces. Returns nullopt after adding a finding.
  std::optional<std::vector<model::Part>> AddShape(const FieldReader& reader,
                                                   const SolidInput& input, model::Part& part);
  /// Sets the part's mesh and shape from `file` and `scale`. File names are relative to `folder`.
  /// Returns false after adding a finding.
  bool ReadMesh(FieldReader& reader, const spec::Entry& entry, const std::filesystem::path& folder,
                model::Part& part);
  /// Returns the mass properties at density 1, in the shape's frame. Returns nullopt for a mesh
  /// whose surface is not closed. `mesh` is the index of the shape's mesh in Object::meshes.
  std::optional<model::MassProperties> UnitMassOf(const model::Shape& shape, int mesh);
  /// Sets a body's mass properties to the sum of its parts' mass properties. Does nothing if an
  /// attached MJCF file specifies the body's mass properties.
  void SumMass(model::Body& body);
  /// Adds the texture of a material and returns its index in Object::textures; nullopt after adding
  /// a finding.
  std::optional<int> AddTexture(sample::Evaluator& values, const spec::Material& material,
                                const std::string& name);
  /// Returns the index of a texture that equals `texture` and is named `own_name` in its spec or
  /// file. Adds the texture if there is none.
  int ShareTexture(const std::string& own_name, model::Texture texture);
  /// Adds a finding if all textures together have too many pixels.
  void CheckPixels();
  /// Returns the index of a mesh that equals `mesh`. If there is none, adds a copy named `name`.
  int ShareMesh(const model::MeshAsset& mesh, const std::string& name);
  /// Returns the name of the file's copy in assets/: the name of the file, with _ in place of
  /// characters that some file systems reject. A file outside of the folder of the object's spec
  /// has a hash of its content in the name, because variants, and objects in one folder, may use
  /// files of one name from several folders. Appends _2, _3, ... if another file of this object has
  /// the name.
  std::string OutputName(const std::filesystem::path& file);

 private:
  /// File and scale from which a mesh was made, and properties of the mesh.
  struct MeshSource {
    std::filesystem::path file;  // empty for inline meshes
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();
    bool is_closed = true;
    std::optional<model::MassProperties> unit_mass = {};  // computed on first use
  };

  void Report(const FieldReader& reader, const SolidInput& input, const solid::Fault& fault);
  std::vector<model::Part> AddSolid(const std::shared_ptr<const solid::Solid>& made,
                                    model::Part& part);
  /// Sets the part's mesh to an inline mesh (MJCF attributes `vertex`, `face`). If the mesh has no
  /// normals, MuJoCo computes its triangles as the convex hull of its vertices.
  void AddInline(const model::TriangleMesh& mesh, model::Part& part);
  void AddFile(const std::filesystem::path& file, const Eigen::Vector3d& scale,
               const Assembler::CachedMesh& content, model::Part& part);
  /// Adds a mesh whose source has the hash `hash`, and returns the index of the mesh.
  int Add(std::unique_ptr<model::MeshAsset> mesh, MeshSource source, std::size_t hash);
  void SetMesh(int index, model::Part& part);
  bool ReadPicture(FieldReader& reader, const spec::Field& field,
                   const std::filesystem::path& folder, model::Texture& texture);

  Assembler& assembler_;
  model::Object& object_;
  diag::Findings& findings_;
  std::vector<MeshSource> sources_;  // parallel to Object::meshes
  // Indices in Object::meshes by hash of the source.
  std::unordered_multimap<std::size_t, int> meshes_;
  std::unordered_multimap<std::string, int> textures_;  // indices by name in the spec or file
  const std::filesystem::path* folder_ = nullptr;
  std::map<std::filesystem::path, std::string> output_names_;
  std::set<std::string> taken_names_;
};

}  // namespace mjforge::assemble
