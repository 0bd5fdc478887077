// Reader of the meshes of an MJCF file, with vertices in the frames of the mesh assets instead of
// MuJoCo's inertial frames.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mjforge/attach/compiled_file.h"
#include "mjforge/model/model.h"

namespace mjforge::attach {

/// Reads the meshes of a file. MuJoCo moves a mesh and its geoms into the inertial frame of the
/// mesh; this class finds the inertial frame, to undo the move.
class MeshReader {
 public:
  /// Loads a model that has only the meshes. Adds a finding if MuJoCo rejects this model.
  MeshReader(const CompiledFile& file, diag::Findings& findings);

  /// Returns X_AM of a compiled mesh: the pose of MuJoCo's frame M in the asset's frame A.
  const model::Pose& FrameOf(int mesh) const { return frames_.at(mesh); }
  /// Returns a compiled mesh as an asset without a name.
  model::MeshAsset Read(int mesh) const;

 private:
  void FindFrames(diag::Findings& findings);
  void ReadDefaults(const XmlElement& section, const Eigen::Vector3d& inherited);
  Eigen::Vector3d ScaleOf(const XmlElement& mesh) const;

  const CompiledFile& file_;
  std::map<int, model::Pose> frames_;
  std::map<std::string, Eigen::Vector3d> scales_;  // `scale` by default class
};

}  // namespace mjforge::attach
