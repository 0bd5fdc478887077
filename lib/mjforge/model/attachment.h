// Content of an MJCF file that becomes part of an object, and the interface to its reader.

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/model/object.h"

namespace mjforge::model {

/// A body of an MJCF file with all its descendants, as a part of an object. The numbers come from
/// MuJoCo's compiler: autolimits, default classes, angle units and inertia options are already
/// applied. The names are those of the file, but characters that specs do not allow in names are
/// replaced, both in the names and in references to them.
struct Attachment {
  /// The requested body, whose parent is -1, and then its descendants, parents before children.
  /// Every body has an explicit inertia (Body::explicit_inertial, Body::mass_properties).
  std::vector<Body> bodies;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<std::unique_ptr<MeshAsset>> meshes;
  /// Elements of contact, equality, tendon, actuator and sensor that refer only to elements of the
  /// attachment. The name of an element is empty if the element has no name in the file.
  std::vector<Section> sections;
  /// Names of the first body's joints, which are removed when the body is attached.
  std::vector<std::string> root_joints;
};

/// Interface to the reader of MJCF files. A library that uses MuJoCo implements it.
class AttachmentSource {
 public:
  virtual ~AttachmentSource() = default;
  /// Returns the body of `file` whose name is `body`, or the first body if `body` is empty. Returns
  /// null after an error. Every call adds all findings about the file, including warnings, at
  /// `mark`, a place in the spec; notes of these findings refer to places in the XML. Each file is
  /// read only once. The result remains valid as long as this source exists.
  virtual const Attachment* Attach(const std::filesystem::path& file, const std::string& body,
                                   diag::SourceMark mark, diag::Findings& findings) = 0;
};

}  // namespace mjforge::model
