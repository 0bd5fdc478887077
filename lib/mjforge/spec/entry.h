// Entries of the lists in a spec: parts, sites, joints, bodies, elements of MJCF sections.

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"
#include "mjforge/spec/fields.h"
#include "mjforge/spec/mjcf_sections.h"
#include "mjforge/spec/values.h"

namespace mjforge::spec {

struct ObjectSpec;

/// A value that is the same in all variants and valid according to the field table. Points,
/// outlines and joint positions are never stored in this form.
struct ConstantValue {
  std::vector<double> numbers;  // 1 for true, 0 for false; empty for a text
  std::string text;             // MJCF of the value: "0.5 0.5 1", "true", "box"
};

/// A key of an element with its value.
struct Field {
  Field(const FieldInfo* field, Value content, diag::SourceMark key);

  const FieldInfo* info = nullptr;
  Value value;
  diag::SourceMark mark;                          // position of the key in the text
  bool is_default = false;                        // true if the value comes from `defaults:`
  std::shared_ptr<const ConstantValue> constant;  // null if the value cannot be a ConstantValue
};

/// A local value of an entry: `let: {gap: 1mm .. 3mm}`.
struct Local {
  std::string name;
  int slot = 0;
  Value value;
};

/// An entry of a list in a spec: `parts:`, `sites:`, `joints:`, `bodies:`, `pose:`, `expect:`, a
/// section of `mjcf:`, and others.
struct Entry {
  const ElementInfo* element = nullptr;
  diag::SourceMark mark;
  std::optional<expr::Expression> condition;
  bool condition_uses_locals = false;
  std::vector<Loop> loops;    // outermost first
  std::vector<Local> locals;  // in the order of the file
  Value name;                 // text; empty if the entry has no name
  // Fields whose kind is a value, without `name`: first those of the entry itself, then defaults
  // for missing keys.
  std::vector<Field> fields;
  // True for a frame, whose pose is in `fields` and whose parts are `children`.
  bool is_frame = false;
  // Parts of a frame; `screw` and `couple` of a joint; inner elements of an MJCF element.
  std::vector<Entry> children;
  // Slot (index of the variable) of torque(NAME) of a joint, or of NAME.pos of a site; -1 if no
  // expression uses the variable.
  int slot = -1;
  // Only for `spec:` of a part or a body: the nested spec, and the values that replace those of its
  // parameters.
  std::shared_ptr<const ObjectSpec> nested;
  std::vector<std::pair<std::string, Value>> overrides;
  // Materials that replace materials of `nested`: pairs of a name in `nested` and a name in this
  // spec.
  std::vector<std::pair<std::string, Value>> substitutes;

  const Field* Find(Key id) const;
  /// Returns the first child that is an element of this kind; null if there is none.
  const Entry* FindChild(const ElementInfo& kind) const;
};

/// The properties of a body that expressions can read (`NAME.top`), in the order of their slots.
enum class BodyProperty { kTop, kBottom, kRadius, kHalfX, kHalfY, kHalfZ, kMass };
/// Returns the names of the properties, "top", "bottom", ..., in the order of BodyProperty.
std::span<const std::string_view> BodyPropertyNames();
/// Prefix of the properties of a body together with all bodies below it: NAME.subtree_mass.
inline constexpr std::string_view kSubtreePrefix = "subtree_";

/// `place:` of a body, which determines the body's pose and parent.
struct PlaceEntry {
  diag::SourceMark mark;
  std::vector<Field> fields;
  std::vector<Field> beside;  // fields of `beside:`; empty if the place has no `beside:`
  std::optional<std::vector<Field>> pile;  // fields of `pile:`, if the place has it

  const Field* Find(Key id) const;
  const Field* FindBeside(Key id) const;
};

/// An entry of `bodies:`: inline parts, another spec, or an MJCF file.
struct BodyEntry {
  Entry head;  // `name`, `if`, `for`, `let`, `spec`; `fields`: parent, pose, mass, mjcf, body
  std::vector<Entry> parts;
  std::vector<Entry> sites;
  std::vector<Entry> regions;
  std::vector<Entry> views;  // cameras and lights
  std::vector<Entry> joints;
  bool has_joints = false;          // the body has `joints:`, possibly `none`
  bool is_free = false;             // `joints: free`
  std::optional<PlaceEntry> place;  // `place:`, which determines pose and parent
  /// Slot of NAME.top; the slots of the other properties follow. -1 if no expression uses a
  /// property of the body.
  int first_property = -1;
  /// Slot of NAME.subtree_top; the slots of the other properties follow. -1 if no expression uses a
  /// property of the subtree.
  int first_subtree_property = -1;
  /// Slots of NAME.PARAMETER, one for each of head.nested->parameters; -1 if expressions cannot use
  /// the parameter.
  std::vector<int> parameter_slots;
};

/// A section of MJCF whose elements the spec gives under `mjcf:`. The pairs of bodies in `contact:
/// exclude:` of the spec are entries of the section `contact`.
struct Section {
  const SectionInfo* info = nullptr;
  std::vector<Entry> entries;  // a single entry if `info->is_element`
};

}  // namespace mjforge::spec
