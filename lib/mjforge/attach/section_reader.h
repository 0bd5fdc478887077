#pragma once

#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "mjforge/attach/asset_reader.h"
#include "mjforge/attach/attributes.h"
#include "mjforge/attach/compiled_file.h"
#include "mjforge/attach/taken.h"

namespace mjforge::attach {

/// A compiled thing that an element of a section names; id -1: none.
struct Reference {
  mjtObj kind = mjOBJ_UNKNOWN;
  int id = -1;
  std::string_view attribute = {};       // that names it; empty: a child of the element does
  std::string_view kind_attribute = {};  // that says its kind; empty: there is none
};

/// Elements of sections (contact, tendon, ...): which can be carried over, and
/// where they go.
class SectionReader {
 public:
  SectionReader(const CompiledFile& file, Taken& taken, model::Attachment& out,
                diag::Findings& findings)
      : file_(file), taken_(taken), out_(out), findings_(findings) {}

  const mjModel& model() const { return file_.model(); }

  /// An element and its attributes, valid until the next one is added.
  struct Added {
    model::Element& element;
    Attributes attributes;
  };
  /// Adds the element, with name, mark and references, if everything it refers to is taken. If only
  /// part of that is taken, a warning says that the element is left out.
  std::optional<Added> Add(std::string_view section, std::string_view tag, mjtObj kind, int id,
                           const std::vector<Reference>& references);

  /// The name given to something that is taken.
  std::string NameOf(Reference reference) const;

  /// Sections in the order of spec::Sections(), without empty ones.
  void Finish();

 private:
  bool IsCarried(mjtObj kind, int id, const std::vector<Reference>& references);
  void Warn(mjtObj kind, int id, Reference outside);

  const CompiledFile& file_;
  Taken& taken_;
  model::Attachment& out_;
  diag::Findings& findings_;
  std::set<diag::SourceMark> warned_composites_;
};

void ReadTendons(SectionReader& sections, AssetReader& assets);
void ReadContacts(SectionReader& sections);
void ReadEqualities(SectionReader& sections);
void ReadActuators(SectionReader& sections);
void ReadSensors(SectionReader& sections);

}  // namespace mjforge::attach
