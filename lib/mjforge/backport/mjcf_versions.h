// Table of the elements and attributes that MJCF gained between MuJoCo 2.2.2 and 4.0, with the
// release that introduced each and its effect, and table of the lists of numbers whose lengths
// changed.
//
// The facts come from MuJoCo's schema (mj_printSchema) in each release, and from its changelog.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mjforge::backport {

/// The part of a model that an element or attribute affects.
enum class Effect {
  kLooks,       // only pictures
  kSpeed,       // only the speed or precision of computations, or how a file is saved
  kSimulation,  // only the simulation of the whole model, not its contents
  kReading,     // a sensor, which has no effect on the model
  kExpansion,   // a group that MuJoCo expands when it compiles the model
  kInclusion,   // another model, which MuJoCo merges when it compiles the model
  kMeaning,     // the contents of the model
};

/// A row of the table of features that MJCF gained: an element, or attributes of some elements.
struct MjcfFeature {
  /// Elements to which the row applies, as tags separated by blanks: a tag alone ("geom"), below a
  /// parent ("visual/rgba"), or all elements of a section ("sensor/*"). The parent "body" also
  /// stands for the world, frames and replicates. An element of `<default>` also belongs to the
  /// section whose defaults it sets.
  std::string_view where;
  /// Attributes to which the row applies, separated by blanks; "name=value" restricts the row to
  /// this value. If empty, the row is about the element itself.
  std::string_view names;
  int since = 0;  // first release with the feature, as mjVERSION_HEADER
  Effect effect = Effect::kMeaning;
  /// The value with which the attribute has no effect; empty if there is no such value.
  std::string_view neutral = {};
};

/// A row of the table of lists of numbers that may have several lengths in later releases.
struct MjcfList {
  std::string_view where;  // in the form of MjcfFeature::where
  std::string_view names;  // attributes, separated by blanks
  int since = 0;           // the first release that accepts another length
  std::size_t most = 0;    // the greatest length that any release accepts
  /// Default values of the list in older releases, which require a list of this length. A shorter
  /// list has these values at its end.
  std::string_view usual;
  /// Value with which numbers beyond the length of `usual` have no effect. If empty, such numbers
  /// have no effect if they equal the first number of the list.
  std::string_view beyond = {};
};

/// Returns the row of the table of lists (MjcfList) for an attribute of the element `tag` below
/// `parent`; null if the table has no such row.
const MjcfList* FindList(std::string_view parent, std::string_view tag, std::string_view attribute);

/// Returns the row of the table of features for the element `tag` below `parent`; null if MuJoCo
/// 2.2.2 has the element, or no release has it.
const MjcfFeature* FindFeature(std::string_view parent, std::string_view tag);
/// Returns the row for an attribute of the element `tag` below `parent`, with this value; null if
/// the table has no such row.
const MjcfFeature* FindFeature(std::string_view parent, std::string_view tag,
                               std::string_view attribute, std::string_view value);

/// Returns true if `where`, a list of tags as in MjcfFeature::where, matches an element `tag` whose
/// parent is `parent`.
bool IsAt(std::string_view where, std::string_view parent, std::string_view tag);
/// Returns true if `names`, in the form of MjcfFeature::names, includes the attribute with this
/// value.
bool HasAttribute(std::string_view names, std::string_view attribute, std::string_view value);

/// Returns the kind of elements that share defaults with this element: the section for elements of
/// `actuator`, `tendon`, `equality` and `sensor`, otherwise the tag. An actuator in `<default>`,
/// such as `<motor>`, has the kind "actuator".
std::string_view ElementKindOf(std::string_view parent, std::string_view tag);

/// Returns the usual spelling of a release: "3.1.4" for 314, "3.10.0" for 3010000.
std::string VersionText(int header);

}  // namespace mjforge::backport
