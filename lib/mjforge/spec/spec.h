// ObjectSpec, a family of objects loaded from YAML and checked before any value is drawn.

#pragma once

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
#include "mjforge/spec/bounds.h"
#include "mjforge/spec/checks.h"
#include "mjforge/spec/constant_json.h"
#include "mjforge/spec/entry.h"
#include "mjforge/spec/fields.h"
#include "mjforge/spec/picture_view_json.h"
#include "mjforge/spec/shapes.h"
#include "mjforge/spec/snapshot.h"
#include "mjforge/spec/values.h"

namespace mjforge::spec {

struct Parameter {
  std::string name;
  diag::SourceMark mark;
  Value value;
  std::string doc;
  std::string unit;
  std::string section;
  std::string source;  // the value as written in the YAML, on one line
  int slot = 0;
  int list = -1;  // index in the expressions' array of lists; -1: not a list
  /// Name of the record if the parameter is the key of a record; otherwise empty. Expressions may
  /// use the name of the record instead of that of the key ("style" for "style.name").
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
  std::vector<Field> texture;    // empty: the material has no texture
  std::filesystem::path folder;  // base of relative paths

  const Field* Find(Key id) const;
};

enum class RootJoints { kFree, kNone, kList };
enum class Placement { kCenter, kCorner };
/// Form of the start state in MJCF: the zero configuration or a keyframe.
enum class StartForm { kZero, kKeyframe };

/// Values for the missing fields of parts, sites and joints.
struct Defaults {
  std::vector<Field> part;
  std::vector<Field> site;
  std::vector<Field> joint;
};

/// The view of the object in pictures: `view:`.
struct PictureView {
  struct Position {
    std::string joint;
    double value = 0;  // rad or m
    expr::Dimension dimension;
    diag::SourceMark mark;
  };
  std::optional<double> azimuth;  // deg, direction of view about z; 0: along x
  // Degrees, direction of view above the horizontal plane; -90: straight down.
  std::optional<double> elevation;
  std::vector<Position> pose;
};

struct ObjectSpec {
  std::string name;
  std::string description;
  std::string file;              // name of the file in findings
  diag::SourceMark mark;         // beginning of the spec
  std::filesystem::path folder;  // base of relative paths
  // Files that were read for the spec, in the order in which they were first read.
  std::vector<std::filesystem::path> files;
  std::string sha256;  // hash of the texts of `files`, in hexadecimal
  /// The applied settings, from parameter files and from the caller: pairs of a name and a value
  /// (YAML flow text).
  std::vector<std::pair<std::string, std::string>> settings;

  expr::SymbolTable names;  // names for expressions; slot 0 is `index`
  // Name of each function, and its position in the text.
  std::vector<std::pair<std::string, diag::SourceMark>> functions;
  std::vector<Parameter> parameters;  // in file order
  std::vector<int> evaluation_order;  // indices into parameters
  /// Imported files with parameters, each as a spec with only a name, parameters and requirements.
  /// All specs that import a file draw the same values, because the draws depend on the name of the
  /// file, not on the importing spec.
  std::vector<std::shared_ptr<const ObjectSpec>> shared;
  std::vector<Requirement> requirements;
  std::vector<Material> materials;  // own materials, then imported ones, in file order
  Defaults defaults;
  std::vector<Entry> parts;
  std::vector<Entry> sites;
  std::vector<Entry> regions;
  std::vector<Entry> views;  // cameras and lights
  RootJoints root_joints = RootJoints::kFree;
  std::vector<Entry> joints;
  std::vector<BodyEntry> bodies;
  std::vector<Entry> pose;     // start values; an entry's name is that of a joint or an actuator
  std::optional<Field> start;  // text of StartForm: "zero" or "keyframe"
  std::vector<Section> sections;
  std::optional<Field> mass;   // kg, of the whole object
  std::optional<Field> front;  // direction of the front: x, y
  Placement placement = Placement::kCenter;
  bool has_place = false;           // true if a body of this spec or of a nested one has `place:`
  DrawKinds draws;                  // kinds of draws in this spec and in nested ones
  std::optional<Field> total_size;  // half sizes of the whole object, m
  std::vector<Expectation> expectations;
  /// Slots of the variables `mass` and `bounds` in expectations; -1 if a parameter has that name.
  int mass_slot = -1;
  int bounds_slot = -1;
  Checks checks;
  PictureView view;

  /// Returns the parameter of this name or, for the name of a record, the key of the record.
  /// Returns null if there is none.
  const Parameter* FindParameter(std::string_view parameter) const;
  /// Returns the value of a parameter of this spec as declared, also if an imported file declares
  /// it.
  const Value& ValueOf(const Parameter& parameter) const;
};

/// A value from the caller for a parameter, a threshold (`checks.tilt`), `root.joints` or
/// `root.start`, in place of the value in the spec.
struct Setting {
  std::string name;
  std::string text;              // YAML flow text: "0.02", "1 .. 2", "{choice: [box, cylinder]}"
  std::string origin = "--set";  // name of the setting's source in findings
};

/// Returns the text in single quotes, as a YAML scalar.
std::string SingleQuoted(std::string_view text);

struct LoadOptions {
  std::vector<Setting> settings = {};
  /// Files with a YAML mapping of parameter names to values (`--params`); applied before
  /// `settings`.
  std::vector<std::filesystem::path> parameter_files = {};
  /// Folders in which specs are searched, in this order: MJFORGE_PATH, then the installed
  /// catalogue.
  std::vector<std::filesystem::path> search_path = {};
  /// Snapshot whose files and texts replace those on the disk; null if none is used. The load adds
  /// all other files that it reads. Two loads must not use one snapshot at the same time.
  Snapshot* snapshot = nullptr;
};

/// Loads the spec that `reference` names: a path, a name relative to a folder of the search path
/// ("tools/hammer"), or the last part of such a name ("hammer"); "-" is standard input. Adds every
/// text that is read to `sources` and every problem to `findings`. Returns null if there is an
/// error.
std::unique_ptr<ObjectSpec> LoadSpec(const std::string& reference, const LoadOptions& options,
                                     diag::Sources& sources, diag::Findings& findings);

/// Loads a spec from a text, like LoadSpec; relative paths are resolved against `folder`.
std::unique_ptr<ObjectSpec> LoadSpecText(const std::string& name, std::string text,
                                         const std::filesystem::path& folder,
                                         const LoadOptions& options, diag::Sources& sources,
                                         diag::Findings& findings);

/// Returns the specs in a folder of the search path: names for LoadSpec ("tools/hammer"), sorted.
std::vector<std::string> ListSpecs(const std::filesystem::path& folder);

/// Returns the text of a spec, changed for a copy in `folder` (empty: the working folder).
/// References to files are rewritten so that they name the same files from `folder`, unless the
/// spec computes the names. The comment line that names the JSON Schema for editors is removed.
/// Returns nullopt, after adding findings, if the spec has errors.
std::optional<std::string> CopiedText(const std::string& reference,
                                      const std::filesystem::path& folder,
                                      const LoadOptions& options, diag::Sources& sources,
                                      diag::Findings& findings);
/// Returns the text of a small commented spec, a starting point for new specs.
std::string StarterText();

/// Returns the text of schemas/object.schema.json, which is made from the field table.
std::string JsonSchema();

/// Returns the reference chapter of the manual (Markdown), which is made from the field table.
std::string FieldReference();

}  // namespace mjforge::spec
