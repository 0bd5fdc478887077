// Meshes and textures of an object as OBJ and PNG files, for programs that read MJCF but neither
// inline meshes nor generated textures.

#pragma once

#include <map>
#include <memory>
#include <string>

#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"

namespace mjforge::files {

/// Generator of the mesh and texture files of documents. Textures are cached between documents.
class Maker {
 public:
  Maker();
  ~Maker();

  /// Makes the files that `document` lacks (MjcfDocument::generated_files), and adds these files to
  /// the document's assets. Inserts a hash of the content into each file's name in the document's
  /// text; files with equal names have equal contents. The result depends only on the object and
  /// the text. Returns false, and adds a finding, if a mesh without faces has no convex hull or if
  /// MuJoCo cannot make a texture.
  bool Make(const model::Object& object, mjcf::MjcfDocument& document, diag::Findings& findings);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mjforge::files
