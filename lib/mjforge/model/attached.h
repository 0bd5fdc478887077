#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <utility>

#include "mjforge/model/materials.h"
#include "mjforge/model/sections.h"

namespace mjforge::model {

class Renamer;  // private to attached.cc

/// Makes a body of an MJCF file one of the object: names get the prefix, assets are shared.
class Attacher {
 public:
  /// What it adds to. `source` may be null: then no file can be read. `bodies` are those of the
  /// object by full name.
  struct Places {
    AttachmentSource* source;
    Object& object;
    Assets& assets;
    Materials& materials;
    Sections& sections;
    References& references;
    std::unordered_map<std::string, int>& bodies;
  };
  Attacher(const Places& places, diag::Findings& findings)
      : source_(places.source),
        object_(places.object),
        assets_(places.assets),
        materials_(places.materials),
        sections_(places.sections),
        references_(places.references),
        bodies_(places.bodies),
        findings_(findings) {}

  /// The file's body becomes the body `index`, `name` in its spec, which is there already. Returns
  /// the number of parts that came with it.
  std::size_t Add(Scope& scope, FieldReader& reader, const spec::Entry& entry,
                  const std::string& name, std::size_t index);

 private:
  void CopyAssets(const Attachment& attachment, Renamer& renamer);
  std::size_t CopyBodies(const Attachment& attachment, const Renamer& renamer, std::size_t index);
  void CopySections(const Attachment& attachment, const Renamer& renamer);
  void AddReferences(References::Place place, const Element& own, const Element& element);

  AttachmentSource* source_;
  Object& object_;
  Assets& assets_;
  Materials& materials_;
  Sections& sections_;
  References& references_;
  std::unordered_map<std::string, int>& bodies_;
  diag::Findings& findings_;
  std::map<std::pair<std::filesystem::path, std::string>, const Attachment*> attached_;
};

}  // namespace mjforge::model
