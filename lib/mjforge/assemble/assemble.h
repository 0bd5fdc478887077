// Assembly of objects: ObjectSpec + drawn values -> Object, with checks of everything that MuJoCo
// would not notice or would not explain.
//
// The assembler asks the evaluator for one value after the other while it adds elements, and
// computes every number of the Object from these values.

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"
#include "mjforge/sample/sample.h"
#include "mjforge/solid/solid.h"

namespace mjforge::assemble {

/// Builds the objects of variants. Keeps the mesh and texture files that it has read and the solids
/// that it has computed, because most variants use them again.
class Assembler {
 public:
  struct Options {
    std::string name;       // name of the object; empty: the spec's
    bool prefix = true;     // put `name_` before every element's name
    std::string root = {};  // name of the root body; empty: the object's
    /// Seed of the draws of `place:` that are not draws of the variant's other values; none: the
    /// variant's seed alone.
    std::optional<std::uint64_t> place_seed = {};
  };

  /// `attachments` reads MJCF files, `placer` searches places; without them a body with `mjcf:` or
  /// `place:` is an error. The assembler refers to the two objects.
  explicit Assembler(model::AttachmentSource* attachments = nullptr,
                     model::Placer* placer = nullptr)
      : attachments_(attachments), placer_(placer) {}

  /// Returns the object; nothing after an error, which is added to the findings.
  std::optional<model::Object> Assemble(sample::Evaluator& values, const Options& options,
                                        diag::Findings& findings);

  struct CachedMesh {
    bool exists = false;
    bool unreadable = false;
    std::optional<solid::TriangleMesh> mesh;
    std::string why_not;                        // if there is no mesh
    std::optional<std::string> surface_defect;  // see FindSurfaceDefect
    bool fit_for_mujoco = true;                 // see MeshFile
  };
  /// Returns the unscaled mesh of a file, which is read only once.
  const CachedMesh& ReadMesh(const std::filesystem::path& file);

  struct CachedTexture {
    bool exists = false;
    std::optional<std::uint64_t> pixels;  // nothing if the file is not PNG or cannot be read
    std::string why_not;                  // if the file cannot be read
  };
  /// Returns the size of a picture, whose file is read only once.
  const CachedTexture& ReadTexture(const std::filesystem::path& file);

  model::AttachmentSource* attachments() const { return attachments_; }
  model::Placer* placer() const { return placer_; }
  solid::Cache& solids() { return solids_; }

 private:
  model::AttachmentSource* attachments_;
  model::Placer* placer_;
  std::map<std::filesystem::path, CachedMesh> meshes_;
  std::map<std::filesystem::path, CachedTexture> textures_;
  solid::Cache solids_;
};

}  // namespace mjforge::assemble
