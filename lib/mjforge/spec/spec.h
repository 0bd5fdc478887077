#pragma once

// YAML text -> ObjectSpec: a family of objects, checked for everything that can
// be checked without drawing a value.

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"
#include "mjforge/spec/checks.h"
#include "mjforge/spec/entry.h"
#include "mjforge/spec/fields.h"
#include "mjforge/spec/shapes.h"
#include "mjforge/spec/values.h"

namespace mjforge::spec {

struct Parameter {
  std::string name;
  diag::SourceMark mark;
  Value value;
  std::string doc;
  std::string unit;
  std::string source;  // the value as written in the YAML, on one line
  int slot = 0;
  int list = -1;  // as expr::Names::Variable::list
  /// Of the key of a record: the record's name, which may stand for the key's ("style" for
  /// "style.name").
  std::string record;
};

struct Requirement {
  expr::Expression expression;
  diag::SourceMark mark;
};

struct Material {
  std::string name;
  diag::SourceMark mark;
  std::vector<Field> fields;
  std::vector<Field> texture;    // empty: none
  std::filesystem::path folder;  // that files resolve against

  const Field* Find(Key id) const;
};

enum class RootJoints { kFree, kNone, kList };
enum class Placement { kCenter, kCorner };

/// Defaults for the fields of parts, sites and joints that an entry leaves out.
struct Defaults {
  std::vector<Field> part;
  std::vector<Field> site;
  std::vector<Field> joint;
};

struct ObjectSpec {
  std::string name;
  std::string description;
  std::string file;                          // as shown to the user
  diag::SourceMark mark;                     // where it begins
  std::filesystem::path folder;              // that relative files resolve against
  std::vector<std::filesystem::path> files;  // every file read, in order of first reading
  std::string sha256;                        // of all their texts, one after the other; hexadecimal
  /// The settings in force, from files and from the caller: name, YAML flow text.
  std::vector<std::pair<std::string, std::string>> settings;

  expr::Names names;  // parameters, loop variables; slot 0 is `index`
  std::vector<std::pair<std::string, diag::SourceMark>> functions;  // in `names`; in file order
  std::vector<Parameter> parameters;                                // in file order
  std::vector<int> evaluation_order;                                // indices into parameters
  /// The parameters of imported files, which all specs that import them share: they are drawn for
  /// themselves, by the file's name, and have only a name, parameters and requirements.
  std::vector<std::shared_ptr<const ObjectSpec>> shared;
  std::vector<Requirement> requirements;
  std::vector<Material> materials;  // own ones first, then imported, in file order
  Defaults defaults;
  std::vector<Entry> parts;
  std::vector<Entry> sites;
  std::vector<Entry> views;  // cameras and lights
  RootJoints root_joints = RootJoints::kFree;
  std::vector<Entry> joints;
  std::vector<BodyEntry> bodies;
  std::vector<JointPosition> pose;
  std::vector<Section> sections;
  std::optional<Field> mass;  // kg, of the whole object
  Placement placement = Placement::kCenter;
  bool has_exact_choice = false;    // it or a spec it brings: a variant depends on the batch's size
  std::optional<Field> total_size;  // half sizes, m
  std::vector<Expectation> expectations;
  /// Slots of `mass` and of the first of `bounds`, for expectations; -1: parameters hide them.
  int mass_slot = -1;
  int bounds_slot = -1;
  Checks checks;

  /// By its name; a key by that of its record, too.
  const Parameter* FindParameter(std::string_view parameter) const;
};

/// A value given from outside in place of a parameter's own, or of a threshold (`checks.tilt`).
struct Setting {
  std::string name;
  std::string text;              // YAML flow text: "0.02", "1 .. 2", "{choice: [box, cylinder]}"
  std::string origin = "--set";  // shown in findings
};

struct LoadOptions {
  std::vector<Setting> settings;
  /// A YAML mapping of parameter names to values (`--params`), before settings.
  std::vector<std::filesystem::path> parameter_files;
  /// Folders with specs, first match wins: MJFORGE_PATH, then the installed catalogue.
  std::vector<std::filesystem::path> search_path;
};

/// Loads the spec that `reference` names: a path, a name relative to a folder
/// of the search path ("tools/hammer"), or a bare last name ("hammer"); "-" is
/// standard input. Adds every text read to `sources` and every error to
/// `findings`; nothing when there was an error.
std::unique_ptr<ObjectSpec> LoadSpec(const std::string& reference, const LoadOptions& options,
                                     diag::Sources& sources, diag::Findings& findings);

/// As LoadSpec, from a text; files in it resolve against `folder`.
std::unique_ptr<ObjectSpec> LoadSpecText(const std::string& name, std::string text,
                                         const std::filesystem::path& folder,
                                         const LoadOptions& options, diag::Sources& sources,
                                         diag::Findings& findings);

/// The bundled specs of a folder of the search path: names as LoadSpec takes
/// them ("tools/hammer"), sorted.
std::vector<std::string> ListSpecs(const std::filesystem::path& folder);

/// schemas/object.schema.json, made from the field table.
std::string JsonSchema();

/// The reference chapter of the manual (Markdown), made from the field table.
std::string FieldReference();

}  // namespace mjforge::spec
