#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::engine {

/// An element of an MJCF file or of a file that it includes.
struct XmlElement {
  std::string tag;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlElement> children;
  diag::SourceMark mark;
  /// A name given to an element without one, seen only by MuJoCo.
  std::string made_name;

  /// An attribute's text; null if it has none.
  const std::string* Find(std::string_view attribute) const;
  void Set(std::string_view attribute, std::string value);
  void Remove(std::string_view attribute);
  /// Its name in the file; empty if it has none.
  std::string Name() const;
  /// "geom 'head'", or "the geom on line 7" if it has no name.
  std::string Description() const;
};

/// A file by its canonical path, if it has one: the same for all names of a file.
std::string CanonicalName(const std::filesystem::path& file);

/// Reads the file with everything it includes into `sources`; nothing after an error. Findings have
/// only notes; their place, in the spec, is set later.
std::optional<XmlElement> ReadXml(const std::filesystem::path& file, diag::Sources& sources,
                                  diag::Findings& findings);

/// A finding whose own place is set later, with a note at `place`.
diag::Finding& AddError(diag::Findings& findings, diag::Code code, diag::SourceMark place,
                        std::string message, std::string hint = {});
diag::Finding& AddWarning(diag::Findings& findings, diag::Code code, diag::SourceMark place,
                          std::string message, std::string hint = {});

}  // namespace mjforge::engine
