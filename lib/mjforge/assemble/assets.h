// Meshes and textures of an object, and the parts made of shapes of the room `solid`.

#pragma once

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

/// Returns the stream of a material's fields.
inline sample::StreamId MaterialPath(const sample::Evaluator& values,
                                     const spec::Material& material) {
  return sample::Child(sample::Child(values.root(), "materials"), material.name);
}

/// Name and places of an outline of a shape, for findings.
struct OutlinePlace {
  std::string name = {};                     // "hole 1 along x"; empty for the outer outline
  std::vector<diag::SourceMark> marks = {};  // places of the outline's points, or empty
};

/// A shape of the room `solid`, and its places in the spec for findings.
struct SolidInput {
  const solid::SolidShape& shape;
  const spec::Field& field;  // field with the outer outline, the path or the size
  /// Indexed by solid::Fault::loop: the outer outline, then the holes.
  const std::vector<OutlinePlace>& outlines;
};

/// Returns `count` factors from `scale`, all 1 without this field; nullopt after a finding.
std::optional<sample::Numbers> ReadScale(FieldReader& reader, const spec::Entry& entry,
                                         std::size_t count);

/// Returns the field; null, after adding a finding, if the entry does not have the field.
const spec::Field* Required(FieldReader& reader, const spec::Entry& entry, spec::Key id,
                            std::string_view key, diag::SourceMark mark);

/// Adds meshes and textures to one object. Parts share equal meshes, materials equal textures.
class Assets {
 public:
  Assets(Assembler& assembler, model::Object& object, diag::Findings& findings)
      : assembler_(assembler), object_(object), findings_(findings) {}

  /// Gives the part the render mesh and the exact mass of a shape of `solid`. Returns the convex
  /// pieces, with poses in the part's frame.
  std::optional<std::vector<model::Part>> AddShape(const FieldReader& reader,
                                                   const SolidInput& input, model::Part& part);
  /// Sets the part's mesh and shape from `file` and `scale`. File names are relative to `folder`.
  bool ReadMesh(FieldReader& reader, const spec::Entry& entry, const std::filesystem::path& folder,
                model::Part& part);
  /// Returns the mass properties at density 1, in the shape's frame; nullopt for a mesh whose
  /// surface is not closed. `mesh` is the mesh's index in Object::meshes.
  std::optional<model::MassProperties> UnitMassOf(const model::Shape& shape, int mesh);
  /// Sets a body's mass properties to the sum of its parts, unless an attached file gave them.
  void SumMass(model::Body& body);
  /// Adds a material's texture. Returns its index; nullopt after a finding.
  std::optional<int> AddTexture(sample::Evaluator& values, const spec::Material& material,
                                const std::string& name);
  /// Returns the index of an equal texture whose name in its spec or file is `own_name`. Adds the
  /// texture if there is none.
  int ShareTexture(const std::string& own_name, model::Texture texture);
  /// Adds a finding if the pictures of all textures together have too many pixels.
  void CheckPixels();
  /// Returns the index of an equal mesh. Adds a copy, called `name`, if there is none.
  int ShareMesh(const model::MeshAsset& mesh, const std::string& name);
  /// Returns the name of the file's copy in assets/: its own name, with _ in place of characters
  /// that some system rejects, and _2, _3, ... appended if another file has the name.
  std::string OutputName(const std::filesystem::path& file);

 private:
  /// Origin of a mesh, by which equal meshes are found.
  struct MeshSource {
    std::filesystem::path file;  // empty for inline meshes
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();
    bool is_closed = true;
    std::optional<model::MassProperties> unit_mass = {};  // computed on first use
  };

  void Report(const FieldReader& reader, const SolidInput& input, const solid::Fault& fault);
  std::vector<model::Part> AddSolid(const std::shared_ptr<const solid::Solid>& made,
                                    model::Part& part);
  /// Adds a mesh that is written inline. A mesh without normals stands for its convex hull.
  void AddInline(const model::TriangleMesh& mesh, model::Part& part);
  void AddFile(const std::filesystem::path& file, const Eigen::Vector3d& scale,
               const Assembler::CachedMesh& content, model::Part& part);
  /// Adds a mesh whose source has this hash, and returns its index.
  int Add(std::unique_ptr<model::MeshAsset> mesh, MeshSource source, std::size_t hash);
  void SetMesh(int index, model::Part& part);
  bool ReadPicture(FieldReader& reader, const spec::Field& field,
                   const std::filesystem::path& folder, model::Texture& texture);

  Assembler& assembler_;
  model::Object& object_;
  diag::Findings& findings_;
  std::vector<MeshSource> sources_;                     // parallel to Object::meshes
  std::unordered_multimap<std::size_t, int> meshes_;    // indices by hash
  std::unordered_multimap<std::string, int> textures_;  // indices by name in the spec or file
  std::map<std::filesystem::path, std::string> output_names_;
  std::set<std::string> taken_names_;
};

}  // namespace mjforge::assemble
