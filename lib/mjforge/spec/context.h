// Functions that read the sections of a spec, and the state that all readers share.

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/spec/spec.h"
#include "mjforge/spec/value_reader.h"
#include "mjforge/spec/yaml.h"

namespace mjforge::spec {

/// Finds and loads the specs and CSV files that a spec refers to.
class NestedLoader {
 public:
  virtual ~NestedLoader() = default;
  /// Loads the spec that `reference` names. Returns null, after adding a finding at `mark`, if
  /// loading fails.
  virtual std::shared_ptr<const ObjectSpec> LoadNested(const std::string& reference,
                                                       diag::SourceMark mark) = 0;
  /// Reads the file `name`, relative to the spec's folder, and returns its number in diag::Sources.
  /// Returns nullopt, and adds a finding, if reading fails.
  virtual std::optional<std::uint32_t> OpenFile(const std::string& name, diag::SourceMark mark) = 0;
};

/// State that all readers of a spec's sections share while the spec is read.
struct Context {
  diag::Sources& sources;
  diag::Findings& findings;
  ObjectSpec& spec;
  NestedLoader& loader;
  ValueReader values;
  // Names of all local values (`let:`), and their positions in the text.
  std::vector<std::pair<std::string, diag::SourceMark>> locals = {};
};

/// Reports each key of the mapping that is not a key of the element, and suggests a similar key
/// that the mapping lacks. Returns the mapping with the suggested keys, to read what was probably
/// meant, because a misspelt section would otherwise lead to a finding at each use of its names.
/// Returns nullopt if all keys are known.
std::optional<YamlNode> CheckKeys(const ElementInfo& element, const YamlNode& map,
                                  Context& context);

/// Adds a finding if the mapping has `key` but not `other`, which `key` requires.
void CheckNeeds(std::string_view key, std::string_view other, const YamlNode& map,
                Context& context);

/// Adds a finding for each of `keys` that the mapping has beside `key`. `reason` is the text that
/// explains why the keys exclude each other.
void RejectBeside(std::string_view key, std::span<const std::string_view> keys, const YamlNode& map,
                  std::string_view reason, Context& context);

/// Returns true if the node is a mapping. Otherwise adds a finding, in which `what` describes the
/// expected content ("a part's keys").
bool IsMap(const YamlNode& node, std::string_view what, Context& context);
/// Returns true if the node is a list. Otherwise adds a finding, in which `what` describes the
/// expected content ("pairs of bodies").
bool IsList(const YamlNode& node, std::string_view what, Context& context);

/// Returns the items of a list, or the node itself if it is a single value. Otherwise returns no
/// items, and adds a finding as IsList() does.
std::span<const YamlNode> OneOrMore(const YamlNode& node, std::string_view what, Context& context);

/// Reads the fields of a mapping whose kind is a value (HoldsValue()), except `name`; skips
/// structures, such as a list of parts. Reports keys that exclude each other (two orientations,
/// density and mass).
std::vector<Field> ReadFields(const ElementInfo& element, const YamlNode& map, Context& context);

/// Reads the fields of an element, as ReadFields() does. Also reports unknown keys, and required
/// fields that the mapping does not have.
std::vector<Field> ReadElementFields(const ElementInfo& element, const YamlNode& text,
                                     Context& context);

/// Reads the mapping under the key `element.name` of `map` into a child of `entry`, and returns the
/// child; null if there is no such mapping.
Entry* ReadChild(const ElementInfo& element, const YamlNode& map, Entry& entry, Context& context);

/// Returns true if the two fields are the same, or if an element may have only one of them: mass
/// and density, pos and fromto.
bool ExcludeEachOther(const FieldInfo& a, const FieldInfo& b);

/// Returns the type of a joint ("hinge") from its field `type`, which may be null; an empty text if
/// the type is drawn or computed.
std::string_view JointType(const Field* type);

/// Returns the field with this key; null if there is none.
const Field* FindField(std::span<const Field> fields, Key id);

/// Adds a finding if `name` is not a valid name in expressions. `what` describes the named thing
/// ("a parameter").
void CheckName(std::string_view what, std::string_view name, diag::SourceMark mark,
               diag::Findings& findings);

/// Returns true if the name is not reserved in expressions (`pi`, `min`, `and`). Otherwise adds a
/// finding, in which `what` describes the named thing ("a parameter").
bool CheckNotReserved(std::string_view what, std::string_view name, diag::SourceMark mark,
                      diag::Findings& findings);

/// Reads `functions:`, and defines the functions for all expressions that are read later.
void ReadFunctions(const YamlNode& functions, Context& context);
/// Checks the expressions that define the functions. Call CheckFunctions() after the parameters are
/// declared.
void CheckFunctions(Context& context);
/// Returns `names` and, for each function among them, the names that the body of the function uses,
/// directly or through other functions.
std::vector<std::string> WithNamesInFunctions(std::vector<std::string> names,
                                              const expr::SymbolTable& known);

/// A setting, which replaces a value of the spec by another one. `name` is that of a parameter,
/// `checks.KEY`, `root.joints` or `root.start`.
struct SettingNode {
  std::string name;
  YamlNode value;
};
/// Reads `params:` and `require:`. Settings replace the values that the spec gives to parameters.
void ReadParameters(const YamlNode* params, const YamlNode* require,
                    std::span<const SettingNode> settings, Context& context);

/// Read `materials:` and `defaults:` of the spec itself or of an imported file.
void ReadMaterials(const YamlNode& materials, const std::filesystem::path& folder, bool imported,
                   Context& context);
void ReadDefaults(const YamlNode& defaults, Context& context);

/// Reads a list of parts, sites, regions, cameras, lights or joints; `list` may be null. Reports
/// repeated names among entries that exist in every variant.
std::vector<Entry> ReadEntries(const ElementInfo& element, const YamlNode* list, Context& context);
/// Reads `regions:` of an object or a body: a list of regions, or the word `auto`; may be null.
std::vector<Entry> ReadRegions(const YamlNode* regions, Context& context);
/// Reads `cameras:` and `lights:` of an object or a body.
std::vector<Entry> ReadViews(const YamlNode& map, Context& context);
void ReadJoints(const YamlNode& joints, Context& context);
/// Reads `screw:` and `couple:` of a joint into children of the joint's entry.
void ReadCouplings(const YamlNode& joint, Entry& entry, Context& context);
/// Reports keys and types of a joint that exclude `detent:`, and a missing `range`.
void CheckDetent(const YamlNode& joint, const Entry& entry, Context& context);
/// Returns true for `joints: free` and false for `joints: none`. Returns nullopt, and adds a
/// finding, for other words.
std::optional<bool> IsFreeWord(const YamlNode& joints, Context& context);
/// Reads a mapping of joint names to positions: `at:` of an expectation or a check, or `pose:`.
std::vector<JointPosition> ReadPositions(const YamlNode& positions, Context& context);
/// Reads the start state of an object: `pose:`, a mapping or a list.
std::vector<Entry> ReadStarts(const YamlNode& pose, Context& context);
/// Reads `view:` of an object.
void ReadView(const YamlNode& view, Context& context);
/// Reads `expect:` of an object.
void ReadExpectations(const YamlNode& list, Context& context);

/// Reads `bodies:` in order, because each body may use properties of earlier bodies. Then reads the
/// joints of the root and of the bodies, which may use properties of all bodies. `bodies` and
/// `joints` may be null.
void ReadBodiesAndJoints(const YamlNode* bodies, const YamlNode* joints, Context& context);
/// Declares a variable for each property of a body (PREFIXtop, PREFIXbottom, ...) and returns the
/// slot (index) of the first variable.
int DeclareBodyProperties(const std::string& prefix, expr::SymbolTable& names);
/// Declares variables for properties that are known only after all bodies are read:
/// NAME.subtree_top and the other properties of subtrees, NAME.pos of sites, and torque(NAME) of
/// the joints in `joint_lists`.
void DeclareWholeProperties(std::span<const YamlNode* const> joint_lists, Context& context);
/// Sets the slot of a joint's entry to that of the variable torque(NAME), if this variable is
/// declared. Reports uses of torque() in the keys of the joint that determine the torque.
void ReadTorqueUse(const YamlNode& joint, Entry& entry, Context& context);

/// Reads `place:` of an entry of `bodies:`; returns nullopt if the entry has no `place:`.
std::optional<PlaceEntry> ReadPlace(const YamlNode& body, Context& context);

/// Read `contact:` and `mjcf:` into ObjectSpec::sections.
void ReadContact(const YamlNode& contact, Context& context);
void ReadSections(const YamlNode& sections, Context& context);

/// The name of the setting that replaces the object's `joints:`.
inline constexpr std::string_view kRootJoints = "root.joints";
/// The name of the setting that replaces the object's `start:`.
inline constexpr std::string_view kRootStart = "root.start";
/// Prefix of the settings that replace values of `checks:`.
inline constexpr std::string_view kChecksPrefix = "checks.";
/// Reads `checks:`, and replaces its values by the settings `checks.KEY`. `checks` may be null.
void ReadChecks(const YamlNode* checks, std::span<const SettingNode> settings, Context& context);

/// Sets the slots of properties of bodies, joints and sites to -1 if no expression uses the
/// property, so that the property is not computed.
void DropUnusedProperties(Context& context);

/// Warns of parameters, functions, local values and the spec's own materials that are never used.
/// `materials` may be null.
void ReportUnused(const YamlNode* materials, Context& context);

/// Reports a missing type. If the type is a literal, also reports fields that the type requires but
/// the part lacks, fields that the type does not take, and a wrong count of sizes.
void CheckPart(const Entry& part, Context& context);

}  // namespace mjforge::spec
