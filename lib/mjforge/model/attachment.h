#ifndef MJFORGE_MODEL_ATTACHMENT_H_
#define MJFORGE_MODEL_ATTACHMENT_H_

// What an MJCF file brings into an object, and the door to who reads it.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/model/object.h"

namespace mjforge::model {

/// One body of an MJCF file with all below it, each with the numbers MuJoCo
/// compiled in that file (autolimits, classes, angles, inertia options and the
/// rest resolved). Names are the file's, made names; references go to them.
struct Attachment {
  /// The first is the body asked for, with parent -1; parents before children.
  /// Every body states its inertia (explicit_inertial, mass_properties).
  std::vector<Body> bodies;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<std::unique_ptr<MeshAsset>> meshes;
  /// contact, equality, tendon, actuator and sensor elements that refer to
  /// nothing outside; unnamed ones stay so.
  std::vector<Section> sections;
  /// Names of the first body's joints, which attaching takes away.
  std::vector<std::string> root_joints;
};

/// Reads MJCF files; implemented where MuJoCo is.
class AttachmentSource {
 public:
  virtual ~AttachmentSource() = default;
  /// The body called `body` in `file` (empty: the first). Findings stand at
  /// `mark`, with notes in the XML, at every call, the warnings, too; null after
  /// an error. Reads each file once and keeps the result as long as it lives.
  virtual const Attachment* Attach(const std::filesystem::path& file, const std::string& body,
                                   diag::SourceMark mark, diag::Findings& findings) = 0;
};

}  // namespace mjforge::model

#endif  // MJFORGE_MODEL_ATTACHMENT_H_
