// Copies a body of an MJCF file, with everything below the body, into the object.

#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <utility>

#include "mjforge/assemble/materials.h"
#include "mjforge/assemble/mjcf_sections.h"

namespace mjforge::assemble {

class Renamer;  // private to attacher.cc

/// Copies bodies of MJCF files into an object. Names get a prefix, and equal assets are shared.
class Attacher {
 public:
  /// The object, and the objects that add elements to it. If `source` is null, no MJCF file can be
  /// read. `bodies` maps full names to indices in Object::bodies.
  struct Context {
    model::AttachmentSource* source;
    model::Object& object;
    Assets& assets;
    Materials& materials;
    Sections& sections;
    References& references;
    std::unordered_map<std::string, int>& bodies;
    diag::Findings& findings;
  };
  explicit Attacher(const Context& context) : context_(context) {}

  /// Copies the MJCF body that the entry names into the existing body `index`, whose name in the
  /// spec is `name`. Returns the number of added parts (geoms); 0 if an error was reported.
  std::size_t Add(Scope& scope, FieldReader& reader, const spec::Entry& entry,
                  const std::string& name, std::size_t index);

 private:
  void CopyAssets(const model::Attachment& attachment, Renamer& renamer);
  std::size_t CopyBodies(const model::Attachment& attachment, const Renamer& renamer,
                         std::size_t index);
  void CopySections(const model::Attachment& attachment, const Renamer& renamer);
  void AddReferences(References::ElementPlace place, const model::Element& own,
                     const model::Element& element);

  Context context_;
  std::map<std::pair<std::filesystem::path, std::string>, const model::Attachment*> attached_;
};

}  // namespace mjforge::assemble
