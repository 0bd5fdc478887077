#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mjforge/model/field_reader.h"
#include "mjforge/model/model.h"
#include "mjforge/solid/solid.h"

namespace mjforge::model {

/// The stream of a material's fields.
inline sample::StreamId MaterialPath(const sample::Evaluator& values,
                                     const spec::Material& material) {
  return sample::Child(sample::Child(values.root(), "materials"), material.name);
}

/// A shape of the room `solid` and its places in the spec, for findings.
struct SolidInput {
  const solid::SolidShape& shape;
  const spec::Field& field;  // the main outline, path or size
  /// Places of the points of each outline: the main one, then the holes.
  const std::vector<std::vector<diag::SourceMark>>& marks;
};

/// The factors of `scale`, that many; 1 without one. Nothing after a finding.
std::optional<sample::Numbers> ReadScale(FieldReader& reader, const spec::Entry& entry,
                                         std::size_t count);

/// The field; null, and a finding, without one.
const spec::Field* Required(FieldReader& reader, const spec::Entry& entry, spec::Key id,
                            std::string_view key, diag::SourceMark mark);

/// The meshes and textures of one object; equal ones are shared.
class Assets {
 public:
  Assets(Assembler& assembler, Object& object, diag::Findings& findings)
      : assembler_(assembler), object_(object), findings_(findings) {}

  /// The part gets the look of a shape that MuJoCo does not have, and the mass of the true solid;
  /// returns its pieces, with their poses in the part's frame. `texture`: its coordinates.
  std::optional<std::vector<Part>> AddShape(const FieldReader& reader, const SolidInput& input,
                                            Part& part);
  /// Sets the part's mesh and shape from file and scale; file names are relative to `folder`.
  bool ReadMesh(FieldReader& reader, const spec::Entry& entry, const std::filesystem::path& folder,
                Part& part);
  /// The solid's mass properties at density 1, in its own frame; nothing for a
  /// mesh whose surface is open.
  std::optional<MassProperties> UnitMassOf(const Shape& shape, int mesh);
  /// Adds a material's texture. Returns its index, or nothing after a finding.
  std::optional<int> AddTexture(sample::Evaluator& values, const spec::Material& material,
                                const std::string& name);
  /// The index of an equal texture with that own name; otherwise adds this one and returns its
  /// index.
  int ShareTexture(const std::string& own_name, Texture texture);
  /// Whether the pictures of all textures fit into memory.
  void CheckPixels();
  /// As ShareTexture, for a mesh that an attached file brings, renamed to `name`.
  int ShareMesh(const MeshAsset& mesh, const std::string& name);
  /// The name of the file's copy: its own with _ for what some system does not take in a name, and
  /// with _2, _3, ... where that is taken.
  std::string OutputName(const std::filesystem::path& file);

 private:
  struct Source {  // of a mesh read from a file
    std::filesystem::path file;
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();
    bool is_solid = true;
    std::optional<MassProperties> unit_mass = {};  // computed on first use
  };

  void Report(const FieldReader& reader, const SolidInput& input, const solid::Fault& fault);
  std::vector<Part> AddSolid(const solid::Solid& solid, Part& part);
  /// A mesh that is written as text; one without normals is a convex hull.
  void AddInline(TriangleMesh mesh, Part& part);
  void AddFile(const std::filesystem::path& file, const Eigen::Vector3d& scale,
               const Assembler::CachedMesh& content, Part& part);
  void Share(int index, Part& part);
  bool ReadPicture(FieldReader& reader, const spec::Field& field,
                   const std::filesystem::path& folder, Texture& texture);

  Assembler& assembler_;
  Object& object_;
  diag::Findings& findings_;
  std::vector<Source> sources_;  // as Object::meshes
  std::unordered_multimap<std::size_t, int> by_hash_;
  std::unordered_multimap<std::string, int> textures_;  // by own name
  std::map<std::filesystem::path, std::string> output_names_;
  std::set<std::string> taken_names_;
};

}  // namespace mjforge::model
