#pragma once

// ObjectSpec + drawn values -> Object: bodies, parts, poses and masses, as numbers only. Checks
// everything that MuJoCo would not notice or would not explain.
//
// An Assembler asks an Evaluator for one value after the other, and every number of the Object is
// computed from these.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/diag/diag.h"
#include "mjforge/model/attachment.h"
#include "mjforge/model/meshes.h"
#include "mjforge/model/object.h"
#include "mjforge/sample/sample.h"
#include "mjforge/solid/solid.h"
#include "mjforge/spec/spec.h"

namespace mjforge::model {

/// Builds objects; keeps what variants share (files read, solids made).
class Assembler {
 public:
  struct Options {
    std::string name;       // of the object; empty: the spec's
    bool prefix = true;     // put `name_` before every element's name
    std::string root = {};  // name of the root body; empty: the object's
  };

  /// `attachments` reads MJCF files; it must outlive the assembler. Without one
  /// an `mjcf:` body is an error.
  explicit Assembler(AttachmentSource* attachments = nullptr) : attachments_(attachments) {}

  /// Nothing after an error, which is in the findings.
  std::optional<Object> Assemble(sample::Evaluator& values, const Options& options,
                                 diag::Findings& findings);

  struct CachedMesh {
    bool exists = false;
    bool unreadable = false;
    std::optional<TriangleMesh> mesh;
    std::string why_not;                       // where there is no mesh
    std::optional<std::string> why_not_solid;  // where there is
    bool fit_for_mujoco = true;                // MuJoCo reads the same surface from the file
  };
  /// The unscaled content of a file, read at most once.
  const CachedMesh& ReadFile(const std::filesystem::path& file);

  struct CachedTexture {
    bool exists = false;
    std::optional<std::uint64_t> pixels;  // nothing: it is not a PNG file, or cannot be read
    std::string why_not;
  };
  /// What kind of file a picture is; each file is looked at only once.
  const CachedTexture& ReadTexture(const std::filesystem::path& file);

  AttachmentSource* attachments() const { return attachments_; }
  /// Tapes use it, too: the assembler must outlive them.
  solid::Cache& solids() { return solids_; }

 private:
  AttachmentSource* attachments_;
  std::map<std::filesystem::path, CachedMesh> files_;
  std::map<std::filesystem::path, CachedTexture> textures_;
  solid::Cache solids_;
};

}  // namespace mjforge::model
