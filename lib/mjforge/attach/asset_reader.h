// Reader of the assets (materials, textures, meshes) that a body of an MJCF file uses.
#pragma once

#include <map>
#include <string>

#include "mjforge/attach/compiled_file.h"
#include "mjforge/attach/mesh_reader.h"
#include "mjforge/attach/name_scope.h"
#include "mjforge/model/model.h"

namespace mjforge::attach {

/// Reads the assets that an attachment (a body of an MJCF file, for use in a spec) uses, each once,
/// and adds them to the attachment.
class AssetReader {
 public:
  AssetReader(const CompiledFile& file, const MeshReader& meshes, NameScope& scope,
              model::Attachment& out)
      : file_(file), meshes_(meshes), scope_(scope), out_(out) {}

  /// Returns the index of a compiled material in Attachment::materials; -1 if `id` is -1 (none).
  int Material(int id);
  /// Returns the material's name in Attachment::materials; an empty text if `id` is -1.
  std::string MaterialName(int id);
  /// Returns the index of a compiled mesh in Attachment::meshes.
  int Mesh(int id);
  /// Returns the pose X_AM of a compiled mesh's frame M, which MuJoCo computes from the inertia of
  /// the mesh, in the frame A of the mesh asset.
  const model::Pose& FrameOf(int mesh) const { return meshes_.FrameOf(mesh); }

 private:
  int Texture(int id);

  const CompiledFile& file_;
  const MeshReader& meshes_;
  NameScope& scope_;
  model::Attachment& out_;
  std::map<int, int> material_numbers_;
  std::map<int, int> texture_numbers_;
  std::map<int, int> mesh_numbers_;
};

}  // namespace mjforge::attach
