#pragma once

// What an MJCF file brings into an object, and the interface to its reader.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/model/object.h"

namespace mjforge::model {

/// One body of an MJCF file with everything below it, with the numbers that MuJoCo compiled in that
/// file (autolimits, classes, angles, inertia options and the rest resolved). Names are the file's,
/// changed where names cannot have their characters; references use the changed names.
struct Attachment {
  /// The first is the requested body, with parent -1; parents before children. Every body states
  /// its inertia (explicit_inertial, mass_properties).
  std::vector<Body> bodies;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<std::unique_ptr<MeshAsset>> meshes;
  /// contact, equality, tendon, actuator and sensor elements that refer to
  /// nothing outside; unnamed ones stay so.
  std::vector<Section> sections;
  /// Names of the first body's joints, which attaching removes.
  std::vector<std::string> root_joints;
};

/// Reads MJCF files; implemented in a room that uses MuJoCo.
class AttachmentSource {
 public:
  virtual ~AttachmentSource() = default;
  /// The body called `body` in `file` (empty: the first); null after an error. Every call adds all
  /// findings, warnings too, at `mark` with notes in the XML. Reads each file once and keeps the
  /// result for its own lifetime.
  virtual const Attachment* Attach(const std::filesystem::path& file, const std::string& body,
                                   diag::SourceMark mark, diag::Findings& findings) = 0;
};

}  // namespace mjforge::model
