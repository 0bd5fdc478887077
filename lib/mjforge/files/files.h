#pragma once

// Meshes and textures of an object -> OBJ and PNG files, for what reads MJCF but takes no inline
// meshes and generates no textures.

#include <map>
#include <memory>
#include <string>

#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"

namespace mjforge::files {

/// Makes the files of documents, one after the other.
class Maker {
 public:
  Maker();
  ~Maker();

  /// Makes what `document` still lacks (MjcfDocument::made_files) and adds it to its assets; the
  /// names in the text get the hashes of the contents, so files of equal names are equal. Depends
  /// on nothing but the object and the text. False, and a finding, if MuJoCo cannot make a texture.
  bool Make(const model::Object& object, mjcf::MjcfDocument& document, diag::Findings& findings);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mjforge::files
