#pragma once

#include <initializer_list>
#include <set>
#include <string_view>
#include <vector>

#include "mjforge/attach/asset_reader.h"
#include "mjforge/attach/attributes.h"
#include "mjforge/attach/compiled_file.h"
#include "mjforge/attach/mujoco_numbers.h"
#include "mjforge/attach/taken.h"

namespace mjforge::attach {

/// A compiled thing that an element of a section names; id -1: none.
struct Reference {
  mjtObj kind = mjOBJ_UNKNOWN;
  int id = -1;
};

/// Elements of sections (contact, tendon, ...): which can be carried over, and
/// where they go.
class SectionReader {
 public:
  SectionReader(const CompiledFile& file, Taken& taken, model::Attachment& out,
                diag::Findings& findings)
      : file_(file), taken_(taken), out_(out), findings_(findings) {}

  const mjModel& model() const { return file_.model(); }

  /// Adds the element, with name and mark, if everything it refers to is taken. If only part of
  /// that is taken, a warning says that the element is left out. The pointer is valid until the
  /// next call.
  model::Element* Add(std::string_view section, std::string_view tag, mjtObj kind, int id,
                      const std::vector<Reference>& references);
  /// Its attributes.
  static Attributes Of(std::string_view section, model::Element& element);

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

/// mjOBJ_XBODY is a body, too.
inline mjtObj Plain(int kind) {
  return kind == mjOBJ_XBODY ? mjOBJ_BODY : static_cast<mjtObj>(kind);
}

void ReadTendons(SectionReader& sections, AssetReader& assets);
void ReadContacts(SectionReader& sections);
void ReadEqualities(SectionReader& sections);
void ReadActuators(SectionReader& sections);
void ReadSensors(SectionReader& sections);

}  // namespace mjforge::attach
