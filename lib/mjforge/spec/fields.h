// The table of the spec language: every key of every element, with kind, unit, bounds and meaning.

#pragma once

// The readers of specs, their hints about misspelled keys, the JSON Schema and the reference
// chapter of the manual use this table.

#include <limits>
#include <span>
#include <string_view>

#include "mjforge/spec/keys.h"

namespace mjforge::spec {

/// The kind of value or structure that a field takes.
enum class FieldKind {
  kNumber,     // a number
  kInteger,    // a number that must be an integer
  kBoolean,    // true or false
  kWord,       // a word from `words`
  kText,       // text, with ${...}
  kNumbers,    // a list of min_count to max_count numbers; a single number needs no brackets
  kPoints,     // a list of points, each a list of min_count to max_count numbers
  kOutlines,   // a list of outlines, each a list of points
  kPosition,   // a position of a joint: a number, or the 4 numbers of a quaternion
  kPlainText,  // text without ${...}
  kStructure,  // a structure, or a value in another form; FieldInfo::structure describes it
  kJoints,     // a word from `words`, or a list of joints
  kFields,     // values for the fields of the element with the name of the key
  kSections,   // sections of MJCF
  kSilence,    // codes of findings with reasons
  kAnything,
};
/// Returns true for kinds of fields that contain a value, which may be drawn or computed, and which
/// ValueReader::Read() reads.
constexpr bool HoldsValue(FieldKind kind) { return kind <= FieldKind::kPosition; }

/// The form of a structure that the reader of a section reads.
struct Structure {
  std::string_view takes = {};   // "list of parts"
  std::string_view schema = {};  // members of its JSON Schema, with markers (see schema.cc)
};

/// Geoms of a part that get the MJCF attribute of a field: the collision geom, the visual geom, or
/// both.
enum class Applies { kBoth, kCollision, kVisual };

/// Motion of a joint, which selects one of two units of a field: "rad or m" is rad for kTurn, m for
/// kSlide. kAny allows both.
enum class Motion { kAny, kTurn, kSlide };

struct FieldInfo {
  std::string_view key = {};
  Key id = Key::kAttribute;
  FieldKind kind = FieldKind::kNumber;
  Structure structure = {};  // only of a field of kind kStructure
  int min_count = 1;
  int max_count = 1;
  /// Unit of the field: "m"; "rad or m" for a hinge or a slide; "s, 1" for the first and the second
  /// number; "any one" for the three numbers of a direction, which may have any common unit; empty
  /// for plain numbers.
  std::string_view unit = {};
  bool any_unit = false;                                    // true if any unit is accepted
  std::string_view default_text = {};                       // default, for the manual; empty: none
  std::string_view words = {};                              // allowed words, separated by spaces
  double lower = -std::numeric_limits<double>::infinity();  // inclusive unless `above`
  double upper = std::numeric_limits<double>::infinity();   // inclusive
  bool above = false;                                       // the lower bound is exclusive
  bool required = false;
  Applies applies = Applies::kBoth;
  /// Kind of MJCF element to whose name the text refers: "joint", "body", "geom", ...; "@objtype":
  /// the attribute objtype of the same element contains the kind; empty: the text is not a
  /// reference.
  std::string_view refers = {};
  std::string_view doc = {};  // meaning, for the manual and the JSON Schema
};

struct ElementInfo {
  std::string_view name;  // "part", "site", ...; used in messages
  std::string_view doc;
  std::span<const FieldInfo> fields;
  std::span<const ElementInfo> children = {};  // allowed inner elements; only in MJCF sections

  const FieldInfo* Find(std::string_view key) const;
  const FieldInfo* Find(Key id) const;
};

extern const ElementInfo kObjectElement;
extern const ElementInfo kParameterElement;  // keys of a parameter that is a mapping
extern const ElementInfo kMaterialElement;
extern const ElementInfo kTextureElement;
extern const ElementInfo kPartElement;
extern const ElementInfo kFrameElement;  // the mapping under `frame:`
extern const ElementInfo kSiteElement;
extern const ElementInfo kRegionElement;
extern const ElementInfo kCameraElement;
extern const ElementInfo kLightElement;
extern const ElementInfo kJointElement;
extern const ElementInfo kScrewElement;   // the mapping under `screw:`
extern const ElementInfo kCoupleElement;  // the mapping under `couple:`
extern const ElementInfo kStartElement;   // an entry of `pose:`
extern const ElementInfo kBodyElement;
extern const ElementInfo kChainElement;  // the mapping under `chain:`
extern const ElementInfo kPlaceElement;
extern const ElementInfo kBesideElement;  // the mapping under `beside:`
extern const ElementInfo kPileElement;    // the mapping under `pile:`
extern const ElementInfo kContactElement;
extern const ElementInfo kExcludeElement;  // an entry of contact: exclude:
extern const ElementInfo kExpectationElement;
extern const ElementInfo kDefaultsElement;
extern const ElementInfo kViewElement;  // the mapping under `view:`
extern const ElementInfo kChecksElement;
extern const ElementInfo kHoldingElement;
extern const ElementInfo kSettlingElement;
extern const ElementInfo kJointCheckElement;
extern const ElementInfo kFittingElement;
extern const ElementInfo kGraspingElement;
extern const ElementInfo kPartCheckElement;
std::span<const ElementInfo* const> AllElements();

}  // namespace mjforge::spec
