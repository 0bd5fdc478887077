#pragma once

// What the readers of one spec share.

#include <memory>
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

/// Finds and loads the specs that a spec refers to.
class NestedLoader {
 public:
  virtual ~NestedLoader() = default;
  /// The spec named at `mark`; null, and a finding, if it cannot be loaded.
  virtual std::shared_ptr<const ObjectSpec> LoadNested(const std::string& reference,
                                                       diag::SourceMark mark) = 0;
  /// The number among the sources of another file that the spec is made of, which resolves against
  /// its folder; nothing, and a finding, if it cannot be read.
  virtual std::optional<std::uint32_t> OpenFile(const std::string& name, diag::SourceMark mark) = 0;
};

struct Context {
  diag::Sources& sources;
  diag::Findings& findings;
  ObjectSpec& spec;
  NestedLoader& loader;
  ValueReader values;
  std::vector<std::pair<std::string, diag::SourceMark>> locals = {};  // names of all `let:`
};

/// Reports keys that the element does not have, with suggestions.
void CheckKeys(const ElementInfo& element, const YamlNode& map, Context& context);

/// Reports a key that has a meaning only beside another one of the mapping.
void CheckNeeds(std::string_view key, std::string_view other, const YamlNode& map,
                Context& context);

/// Is the node a mapping? If not, a finding that says what was expected.
bool IsMap(const YamlNode& node, std::string_view what, Context& context);
bool IsList(const YamlNode& node, std::string_view what, Context& context);

/// The value fields of a mapping, without structure. Reports fields that say the same thing twice
/// (two orientations, density and mass).
std::vector<Field> ReadFields(const ElementInfo& element, const YamlNode& map, Context& context);

/// Whether an element may have only one of the two: mass and density, pos and fromto.
bool ExcludeEachOther(const FieldInfo& a, const FieldInfo& b);

/// The field of a key; null: it is not there.
const Field* FindField(std::span<const Field> fields, Key id);

/// Adds a finding unless expr::IsName(name).
void CheckName(std::string_view what, std::string_view name, diag::SourceMark mark,
               diag::Findings& findings);

/// Whether the name of `what` ("a parameter") is not one that means something in every expression:
/// `pi`, `min`, `and`. Else a finding.
bool CheckNotReserved(std::string_view what, std::string_view name, diag::SourceMark mark,
                      diag::Findings& findings);

/// Reads functions:, which expressions may call from here on.
void ReadFunctions(const YamlNode& functions, Context& context);
/// Checks their bodies, once the parameters are known.
void CheckFunctions(Context& context);
/// Adds the names in the bodies of functions that are among `names`.
std::vector<std::string> WithNamesInFunctions(std::vector<std::string> names,
                                              const expr::Names& known);

/// Reads params:, with settings in place of the parameters' own values.
struct NamedNode {
  std::string name;
  YamlNode value;
};
void ReadParameters(const YamlNode* params, const YamlNode* require,
                    std::span<const NamedNode> settings, Context& context);

/// materials: and defaults:, of the spec itself or of an imported file.
void ReadMaterials(const YamlNode& materials, const std::filesystem::path& folder, bool imported,
                   Context& context);
void ReadDefaults(const YamlNode& defaults, Context& context);

void ReadParts(const YamlNode& parts, std::vector<Entry>& out, Context& context);
void ReadSites(const YamlNode& sites, Context& context);
/// cameras: and lights: of an object or a body.
void ReadViews(const YamlNode& map, std::vector<Entry>& out, Context& context);
void ReadJoints(const YamlNode& joints, Context& context);
/// Of joints that are one word: whether it is `free` or `none`; else a finding.
std::optional<bool> IsFreeWord(const YamlNode& joints, Context& context);
/// pose: of an object, at: of an expectation.
std::vector<JointPosition> ReadPositions(const YamlNode& positions, Context& context);
/// expect: of an object.
void ReadExpectations(const YamlNode& list, Context& context);

/// Reads bodies: in order, since each may use properties of earlier ones.
void ReadBodies(const YamlNode& bodies, Context& context);

/// contact: and mjcf:, as sections of the spec.
void ReadContact(const YamlNode& contact, Context& context);
void ReadSections(const YamlNode& sections, Context& context);

/// Reads checks:, with settings named `checks.KEY` in place of its own values. `checks` may be
/// null.
inline constexpr std::string_view kChecksPrefix = "checks.";
/// The name of the setting that replaces the object's `joints:`.
inline constexpr std::string_view kRootJoints = "root.joints";
void ReadChecks(const YamlNode* checks, std::span<const NamedNode> settings, Context& context);

/// Forgets the properties (NAME.top) of bodies that no expression asks for: they need not be
/// computed.
void DropUnusedProperties(Context& context);

/// Warns of parameters, and of materials of the spec itself, that nothing uses. `materials` may be
/// null.
void ReportUnused(const YamlNode* materials, Context& context);

/// Checks what a part's literal type tells about its fields: which are required, which have no
/// meaning, how many sizes it takes.
void CheckPart(const Entry& part, Context& context);

/// Reports two entries that certainly exist and have the same name.
void CheckUniqueNames(std::string_view what, std::span<const Entry> entries, Context& context);

}  // namespace mjforge::spec
