// An MJCF file, compiled by MuJoCo, and the XML elements of the compiled things.
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
/// Kinds are MuJoCo's (mjOBJ_GEOM, ...).
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

  /// Returns the element from which MuJoCo compiled only this thing; null if a composite or a
  /// replicate made the thing.
  const XmlElement* ElementOf(mjtObj kind, int id) const;
  /// Returns the element from which MuJoCo compiled a thing. If a composite or a replicate made it,
  /// returns the composite or the replicated element with the longest name that the thing's name
  /// begins with, or else the first composite or the root.
  const XmlElement& OriginOf(mjtObj kind, int id) const;
  /// Returns the name of a compiled thing; empty if it has none in the file.
  std::string NameOf(mjtObj kind, int id) const;
  /// Returns the place of OriginOf().
  diag::SourceMark MarkOf(mjtObj kind, int id) const { return OriginOf(kind, id).mark; }
  /// Returns "geom 'head'" or "the geom on line 7".
  std::string Description(mjtObj kind, int id) const;

 private:
  CompiledFile() = default;
  /// Compiles the file. If MuJoCo rejects it, adds an error and leaves model_ null.
  void Load(diag::Findings& findings);
  /// Returns a message of MuJoCo with the file's names of files and elements.
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
