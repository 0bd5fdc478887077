// Content of an MJCF file that becomes part of an object, and the interface to its reader.

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/model/object.h"

namespace mjforge::model {

/// A body of an MJCF file, and everything below it. The numbers come from MuJoCo's compiler:
/// autolimits, default classes, angle units and inertia options are already applied. The names are
/// those of the file. Characters that specs do not allow in names are replaced, also in references.
struct Attachment {
  /// The requested body comes first, with parent -1, and parents come before children. Every body
  /// has an explicit inertia (explicit_inertial, mass_properties).
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
  /// Returns the body named `body` of `file`; the first body if `body` is empty. Returns null after
  /// an error. Every call adds all findings of the file, including warnings, at `mark`, with notes
  /// that refer to places in the XML. Each file is read only once; the result remains valid as long
  /// as this source exists.
  virtual const Attachment* Attach(const std::filesystem::path& file, const std::string& body,
                                   diag::SourceMark mark, diag::Findings& findings) = 0;
};

}  // namespace mjforge::model
