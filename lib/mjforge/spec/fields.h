#pragma once

// The one table that describes the language: every key of every element, with
// type, unit, bounds, default and meaning. The parser, its suggestions, the
// JSON Schema and the manual's reference all come from it.

#include <limits>
#include <span>
#include <string_view>

#include "mjforge/spec/keys.h"

namespace mjforge::spec {

/// What may stand in a field.
enum class FieldKind {
  kNumber,     // one number
  kInteger,    // one number that must be whole
  kBoolean,    // true or false
  kWord,       // one of `words`
  kText,       // text, with ${...}
  kNumbers,    // a list of min_count to max_count numbers; one number alone is a list of one
  kPoints,     // a list of points, each a list of min_count to max_count numbers
  kOutlines,   // a list of lists of points
  kPlainText,  // text without ${...}
  kFormat,     // the number 1
  // structure
  kParameters,
  kFunctions,
  kConditions,
  kCondition,
  kLoops,
  kLocals,
  kMaterials,
  kDefaults,
  kImports,
  kParts,
  kSites,
  kCameras,
  kLights,
  kJoints,
  kPose,
  kTexture,
  kOverrides,
  kSubstitutes,
  kFields,
  kBodies,
  kPositions,
  kContact,
  kExcludes,
  kBodyPair,
  kExpectations,
  kSections,
  kChecks,
  kHolding,
  kJointChecks,
  kFittings,
  kGrasping,
  kPartChecks,
  kNames,
  kSilence,
  kAnything,
};
/// Whether it holds one value, which may be drawn or computed.
constexpr bool HoldsValue(FieldKind kind) { return kind <= FieldKind::kOutlines; }

/// Which of a part's two geoms an attribute is written to.
enum class Applies { kBoth, kCollision, kVisual };

enum class Motion { kAny, kTurn, kSlide };  // decides between the two units of a joint's field

struct FieldInfo {
  std::string_view key;
  Key id = Key::kAttribute;
  FieldKind kind = FieldKind::kNumber;
  int min_count = 1;
  int max_count = 1;
  /// "m"; "rad or m" of what turns or slides; "s, 1" of the first, the second; "any one" of the
  /// three numbers of a direction; empty: plain numbers.
  std::string_view unit = {};
  bool any_unit = false;                                    // the unit is not known here
  std::string_view default_text = {};                       // as the manual shows it; empty: none
  std::string_view words = {};                              // allowed words, one space apart
  double lower = -std::numeric_limits<double>::infinity();  // inclusive unless `above`
  double upper = std::numeric_limits<double>::infinity();   // inclusive
  bool above = false;                                       // value must be greater than `lower`
  bool required = false;
  Applies applies = Applies::kBoth;
  /// What the text refers to: "joint", "body", "geom", ...; "@objtype": the kind given by the
  /// attribute objtype of the same element. Empty: nothing.
  std::string_view refers = {};
  std::string_view doc = {};  // one sentence
};

struct ElementInfo {
  std::string_view name;  // "part", "site", ...; its name in messages
  std::string_view doc;
  std::span<const FieldInfo> fields;
  std::span<const ElementInfo> children = {};  // of an element of a section: what it may contain

  const FieldInfo* Find(std::string_view key) const;
  const FieldInfo* Find(Key id) const;
};

extern const ElementInfo kObjectElement;
extern const ElementInfo kParameterElement;  // the long form's extra keys
extern const ElementInfo kMaterialElement;
extern const ElementInfo kTextureElement;
extern const ElementInfo kPartElement;
extern const ElementInfo kFrameElement;  // the mapping under `frame:`
extern const ElementInfo kSiteElement;
extern const ElementInfo kCameraElement;
extern const ElementInfo kLightElement;
extern const ElementInfo kJointElement;
extern const ElementInfo kBodyElement;
extern const ElementInfo kContactElement;
extern const ElementInfo kExcludeElement;  // an entry of contact: exclude:
extern const ElementInfo kExpectationElement;
extern const ElementInfo kDefaultsElement;
extern const ElementInfo kChecksElement;
extern const ElementInfo kHoldingElement;
extern const ElementInfo kJointCheckElement;
extern const ElementInfo kFittingElement;
extern const ElementInfo kGraspingElement;
extern const ElementInfo kPartCheckElement;
std::span<const ElementInfo* const> AllElements();

}  // namespace mjforge::spec
