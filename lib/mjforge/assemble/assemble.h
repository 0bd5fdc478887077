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

/// Builds the objects of variants. Caches mesh files, texture files and solids, because most
/// variants use the same ones again.
class Assembler {
 public:
  struct Options {
    std::string name;       // name of the object; empty: that of the spec
    bool prefix = true;     // begin each element's name with the object's and "_"
    std::string root = {};  // name of the root body; empty: that of the object
    /// Additional seed, for the draws of `place:` only; nullopt: these draws depend on the
    /// variant's seed alone.
    std::optional<std::uint64_t> place_seed = {};
  };

  /// `attachments` reads MJCF files; if it is null, a body with `mjcf:` is an error. `placer` finds
  /// places; if it is null, a body with `place:` is an error. The assembler must not outlive them.
  explicit Assembler(model::AttachmentSource* attachments = nullptr,
                     model::Placer* placer = nullptr)
      : attachments_(attachments), placer_(placer) {}

  /// Returns the object; nullopt after an error, which is added to the findings.
  std::optional<model::Object> Assemble(sample::Evaluator& values, const Options& options,
                                        diag::Findings& findings);

  struct CachedMesh {
    bool exists = false;
    bool unreadable = false;
    std::optional<solid::TriangleMesh> mesh;
    std::string why_not;                        // reason, if there is no mesh
    std::optional<std::string> surface_defect;  // see FindSurfaceDefect
    bool fit_for_mujoco = true;                 // see MeshFile::fit_for_mujoco
  };
  /// Returns the unscaled mesh of a file, which is read only once.
  const CachedMesh& ReadMesh(const std::filesystem::path& file);

  struct CachedTexture {
    bool exists = false;
    std::optional<std::uint64_t> pixels;  // nullopt if the file is not PNG or cannot be read
    std::string why_not;                  // reason, if the file cannot be read
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
