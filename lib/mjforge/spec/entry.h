#pragma once

// What the lists of a spec hold: parts, sites, joints, bodies, elements of sections.

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
#include "mjforge/spec/sections.h"
#include "mjforge/spec/values.h"

namespace mjforge::spec {

struct ObjectSpec;

/// One key of an element with its value.
struct Field {
  const FieldInfo* info = nullptr;
  Value value;
  diag::SourceMark mark;    // of the key
  bool is_default = false;  // the entry leaves it out
};

/// One of `let: {gap: 1mm .. 3mm}`.
struct Local {
  std::string name;
  int slot = 0;
  Value value;
};

/// One entry of `parts:`, `sites:`, `joints:`, `contact: exclude:` or of a section of `mjcf:`.
struct Entry {
  const ElementInfo* element = nullptr;
  diag::SourceMark mark;
  std::optional<expr::Expression> condition;
  bool condition_uses_locals = false;
  std::vector<Loop> loops;    // outermost first
  std::vector<Local> locals;  // in order
  Value name;                 // text; empty for a frame without a name
  // All but if, for, name and structure: its own, then the defaults for what it leaves out.
  std::vector<Field> fields;
  // A frame: its pose is in `fields`, the parts it moves are here. Of a section's
  // element: the elements in it.
  bool is_frame = false;
  std::vector<Entry> children;
  // A part or a body with `spec:`: the spec welded in, and the parameters set for it.
  std::shared_ptr<const ObjectSpec> nested;
  std::vector<std::pair<std::string, Value>> overrides;
  // Of its materials, by name: the name of the one of this spec that is used in its place.
  std::vector<std::pair<std::string, Value>> substitutes;

  const Field* Find(Key id) const;
};

/// The properties of a body that expressions read as `NAME.top` and so on, in the order of their
/// slots.
enum class BodyProperty { kTop, kBottom, kRadius, kHalfX, kHalfY, kHalfZ, kMass };
/// "top", "bottom", ... in that order.
std::span<const std::string_view> BodyPropertyNames();

/// One entry of `bodies:`: inline parts, another spec, or an MJCF file.
struct BodyEntry {
  Entry head;  // name, if, for; spec and overrides; parent, pose, mass, mjcf, body as fields
  std::vector<Entry> parts;
  std::vector<Entry> sites;
  std::vector<Entry> views;  // cameras and lights
  std::vector<Entry> joints;
  bool is_free = false;  // `joints: free`
  /// FieldKind of NAME.top; the other properties follow. -1: no expression asks for them.
  int first_property = -1;
  std::vector<int> parameter_slots;  // of NAME.param, as head.nested->parameters
};

/// One section of `mjcf:`, or the one that `contact:` fills.
struct Section {
  const SectionInfo* info = nullptr;
  std::vector<Entry> entries;  // of an element section: one
};

}  // namespace mjforge::spec
