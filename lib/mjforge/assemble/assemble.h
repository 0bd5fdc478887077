// Assembler: builds the Object of one variant (an object model that can be written as MJCF) from an
// ObjectSpec. Reports everything that MuJoCo would not notice or would not explain.
//
// The values of the spec's expressions, which may be random, come from a sample::Evaluator. The
// assembler requests them one after the other while it adds elements.

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

/// Builds objects. Caches mesh files, texture files and solids, because most variants of a spec use
/// the same ones.
class Assembler {
 public:
  struct Options {
    std::string name;       // name of the object; empty: the spec's name
    bool prefix = true;     // true: each element's name begins with the object's name and "_"
    std::string root = {};  // name of the root body; empty: the object's name
    /// Seed of the random poses of `place:`, in addition to the variant's seed. If nullopt, these
    /// poses depend on the variant's seed alone. No other draw depends on this seed.
    std::optional<std::uint64_t> place_seed = {};
  };

  /// `attachments` reads MJCF files; if it is null, a body with `mjcf:` is an error. `placer` finds
  /// places for bodies; if it is null, a body with `place:` is an error. The two objects must
  /// outlive the assembler.
  explicit Assembler(model::AttachmentSource* attachments = nullptr,
                     model::Placer* placer = nullptr)
      : attachments_(attachments), placer_(placer) {}

  /// Returns the object for the values that `values` draws. Returns nullopt, and adds a finding, if
  /// there is an error.
  std::optional<model::Object> Assemble(sample::Evaluator& values, const Options& options,
                                        diag::Findings& findings);

  struct CachedMesh {
    bool exists = false;
    bool unreadable = false;
    std::optional<solid::TriangleMesh> mesh;
    std::string why_not;                        // reason why `mesh` is nullopt
    std::optional<std::string> surface_defect;  // reason why the surface is not closed
    bool fit_for_mujoco = true;                 // see MeshFile::fit_for_mujoco
  };
  /// Returns the content of a mesh file, not scaled. Each file is read only once.
  const CachedMesh& ReadMesh(const std::filesystem::path& file);

  struct CachedTexture {
    bool exists = false;
    // Count of pixels; nullopt if the file is not a PNG file or cannot be read.
    std::optional<std::uint64_t> pixels;
    std::string why_not;  // reason why `pixels` is nullopt
  };
  /// Returns the count of pixels of a picture. Each file is read only once.
  const CachedTexture& ReadTexture(const std::filesystem::path& file);

  /// Returns bytes::HashOf the content of a file; an empty text if the file cannot be read. Each
  /// file is read only once.
  const std::string& HashOf(const std::filesystem::path& file);

  model::AttachmentSource* attachments() const { return attachments_; }
  model::Placer* placer() const { return placer_; }
  solid::Cache& solids() { return solids_; }

 private:
  model::AttachmentSource* attachments_;
  model::Placer* placer_;
  std::map<std::filesystem::path, CachedMesh> meshes_;
  std::map<std::filesystem::path, CachedTexture> textures_;
  std::map<std::filesystem::path, std::string> hashes_;
  solid::Cache solids_;
};

}  // namespace mjforge::assemble
