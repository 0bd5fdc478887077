#pragma once

#include <map>
#include <string>

#include "mjforge/attach/compiled_file.h"
#include "mjforge/attach/mesh_reader.h"
#include "mjforge/attach/taken.h"
#include "mjforge/model/model.h"

namespace mjforge::attach {

/// Reads the assets that an attachment asks for, each once, and adds them to what it takes.
class AssetReader {
 public:
  AssetReader(const CompiledFile& file, const MeshReader& meshes, Taken& taken,
              model::Attachment& out)
      : file_(file), meshes_(meshes), taken_(taken), out_(out) {}

  /// The index of a compiled material in Attachment::materials; -1 for -1.
  int Material(int id);
  /// Its name there; empty for -1.
  std::string MaterialName(int id);
  /// The index of a compiled mesh in Attachment::meshes.
  int Mesh(int id);
  /// The pose of the frame that MuJoCo gives a mesh, in the frame of its asset.
  const model::Pose& FrameOf(int mesh) const { return meshes_.FrameOf(mesh); }

 private:
  int Texture(int id);

  const CompiledFile& file_;
  const MeshReader& meshes_;
  Taken& taken_;
  model::Attachment& out_;
  std::map<int, int> material_numbers_;
  std::map<int, int> texture_numbers_;
  std::map<int, int> mesh_numbers_;
};

}  // namespace mjforge::attach
