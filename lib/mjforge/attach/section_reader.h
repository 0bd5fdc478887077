// Carries elements of sections over to an attachment.
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

/// A reference from an element of a section to a compiled thing; id -1 if there is none.
struct Reference {
  mjtObj kind = mjOBJ_UNKNOWN;
  int id = -1;
  std::string_view attribute = {};       // has the name; empty if a child element has it
  std::string_view kind_attribute = {};  // has the kind; empty if there is none
};

/// Carries elements of sections (contact, tendon, ...) over to an attachment.
class SectionReader {
 public:
  SectionReader(const CompiledFile& file, NameScope& scope, model::Attachment& out,
                diag::Findings& findings)
      : file_(file), scope_(scope), out_(out), findings_(findings) {}

  const mjModel& model() const { return file_.model(); }

  /// An element that was added, and its attributes; valid until the next one is added.
  struct Added {
    model::Element& element;
    Attributes attributes;
  };
  /// Adds an element with name, place and references if the attachment contains all things that the
  /// element refers to. If it contains only some of them, warns that the element is left out.
  std::optional<Added> Add(std::string_view section, std::string_view tag, mjtObj kind, int id,
                           const std::vector<Reference>& references);

  /// Returns the name in the attachment of something that it contains.
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
