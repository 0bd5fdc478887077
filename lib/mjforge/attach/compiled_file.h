#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/engine/engine.h"

namespace mjforge::attach {

using engine::AddError;
using engine::AddWarning;
using engine::XmlElement;

/// An MJCF file: its elements, what MuJoCo compiled from them, and which
/// belongs to which. Kinds are MuJoCo's (mjOBJ_GEOM, ...).
class CompiledFile {
 public:
  /// Nothing after an error.
  static std::unique_ptr<CompiledFile> Read(const std::filesystem::path& file,
                                            engine::Engine& engine, diag::Sources& sources,
                                            diag::Findings& findings);

  const std::filesystem::path& file() const { return file_; }
  const XmlElement& root() const { return root_; }
  const mjModel& model() const { return *model_; }
  engine::Engine& engine() const { return *engine_; }

  /// The element that became a compiled thing alone; null if a composite or a replicate made it.
  const XmlElement* ElementOf(mjtObj kind, int id) const;
  /// Its name in the file; empty if it has none.
  std::string NameOf(mjtObj kind, int id) const;
  /// The place of its element, or of the composite or the replicated element that made it.
  diag::SourceMark MarkOf(mjtObj kind, int id) const { return OriginOf(kind, id).mark; }
  /// "geom 'head'", "the geom on line 7".
  std::string Description(mjtObj kind, int id) const;

 private:
  CompiledFile() = default;
  /// Leaves no model, but an error, if MuJoCo refuses the file.
  void Load(diag::Findings& findings);
  /// Masses of meshes as those whom the file was written for compute them.
  void Weigh();
  /// A message of MuJoCo, with files and elements named as in the file.
  std::string InWordsOfFile(std::string text) const;
  void MapElements();
  /// The element of a compiled thing, or the composite or replicated element whose name its name
  /// begins with; the first composite or the root if there is none.
  const XmlElement& OriginOf(mjtObj kind, int id) const;

  std::filesystem::path file_;
  XmlElement root_;
  engine::FileNames file_names_;
  engine::FlatText flat_;
  engine::Engine* engine_ = nullptr;
  engine::Model model_;
  std::map<std::pair<int, std::string>, const XmlElement*> elements_;
  std::vector<const XmlElement*> composites_;
};

/// MJCF's word for the kind: "geom", "body", ...
std::string KindName(mjtObj kind);

}  // namespace mjforge::attach
