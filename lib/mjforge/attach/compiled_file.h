// An MJCF file, its model as compiled by MuJoCo, and the XML elements of the compiled objects.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/engine/engine.h"
#include "mjforge/xml/xml.h"

namespace mjforge::attach {

using xml::AddError;
using xml::AddWarning;
using xml::XmlElement;

/// An MJCF file: its elements, the model that MuJoCo compiled from it, and a map between the two.
/// Kinds are values of mjtObj (mjOBJ_GEOM, ...).
class CompiledFile {
 public:
  /// Reads and compiles a file. Returns null after an error.
  static std::unique_ptr<CompiledFile> Read(const std::filesystem::path& file,
                                            engine::Engine& engine, diag::Sources& sources,
                                            diag::Findings& findings);

  const std::filesystem::path& file() const { return file_; }
  const XmlElement& root() const { return root_; }
  const mjModel& model() const { return *model_; }
  engine::Engine& engine() const { return *engine_; }

  /// Returns the XML element of a compiled object; null if the object has no element of its own,
  /// because a composite or a replicate made the object.
  const XmlElement* ElementOf(mjtObj kind, int id) const;
  /// Returns the XML element from which MuJoCo compiled an object. Objects that a composite or a
  /// replicate made have no element of their own, but their names begin with the composite's
  /// `prefix` or with the name of a replicated element. For such an object, returns the element
  /// with the longest matching prefix or name; if none matches, the first composite, or the root if
  /// there is no composite.
  const XmlElement& OriginOf(mjtObj kind, int id) const;
  /// Returns the name of a compiled object; an empty text if the object has no name in the file.
  std::string NameOf(mjtObj kind, int id) const;
  /// Returns the place in the file of the element that OriginOf() returns.
  diag::SourceMark MarkOf(mjtObj kind, int id) const { return OriginOf(kind, id).mark; }
  /// Returns "geom 'head'" or "the geom on line 7".
  std::string Description(mjtObj kind, int id) const;

 private:
  CompiledFile() = default;
  /// Returns false after adding an error if MuJoCo must not read the file or one of its assets, for
  /// example a mesh with an index out of range (see engine::FindFileFault()).
  bool CheckFiles(diag::Findings& findings);
  /// Compiles the file. If MuJoCo rejects the file, adds an error and leaves model_ null.
  void Load(diag::Findings& findings);
  /// Returns a message of MuJoCo with the original names of files and elements, in place of
  /// absolute paths and generated names.
  std::string WithOriginalNames(std::string text) const;
  void MapElements();

  std::filesystem::path file_;
  XmlElement root_;
  xml::FileNames file_names_;
  xml::FlatText flat_;
  engine::Engine* engine_ = nullptr;
  engine::Model model_;
  std::map<std::pair<int, std::string>, const XmlElement*> elements_;
  std::vector<const XmlElement*> composites_;
};

/// Returns the MJCF keyword of a kind: "geom", "body", ...
std::string KindName(mjtObj kind);

}  // namespace mjforge::attach
