// Reader of the elements of MJCF sections (contact, tendon, ...) that refer to an attached body.
#pragma once

#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "mjforge/attach/asset_reader.h"
#include "mjforge/attach/attributes.h"
#include "mjforge/attach/compiled_file.h"
#include "mjforge/attach/name_scope.h"

namespace mjforge::attach {

/// A reference from an element of a section to a compiled object; `id` is -1 if there is none.
struct Reference {
  mjtObj kind = mjOBJ_UNKNOWN;
  int id = -1;
  std::string_view attribute = {};       // attribute that names the target; empty: a child names it
  std::string_view kind_attribute = {};  // attribute with the target's kind (objtype); empty: none
};

/// Copies elements of sections (contact, tendon, ...) into an attachment (a body of an MJCF file,
/// for use in a spec).
class SectionReader {
 public:
  SectionReader(const CompiledFile& file, NameScope& scope, model::Attachment& out,
                diag::Findings& findings)
      : file_(file), scope_(scope), out_(out), findings_(findings) {}

  const mjModel& model() const { return file_.model(); }

  /// An added element and its attributes; valid until the next element is added.
  struct Added {
    model::Element& element;
    Attributes attributes;
  };
  /// Adds an element with its name, position in the file and references, if the attachment contains
  /// the targets of all references. Otherwise returns nullopt, and adds a warning if the attachment
  /// contains only some of the targets.
  std::optional<Added> Add(std::string_view section, std::string_view tag, mjtObj kind, int id,
                           const std::vector<Reference>& references);

  /// Returns the name that the target of a reference has in the attachment.
  std::string NameOf(Reference reference) const;

  /// Sorts the sections in the order of spec::Sections().
  void Finish();

 private:
  bool IsCarried(mjtObj kind, int id, const std::vector<Reference>& references);
  void Warn(mjtObj kind, int id, Reference outside);

  const CompiledFile& file_;
  NameScope& scope_;
  model::Attachment& out_;
  diag::Findings& findings_;
  std::set<diag::SourceMark> warned_;
};

void ReadTendons(SectionReader& sections, AssetReader& assets);
void ReadContacts(SectionReader& sections);
void ReadEqualities(SectionReader& sections);
void ReadActuators(SectionReader& sections);
void ReadSensors(SectionReader& sections);

}  // namespace mjforge::attach
