// An element of an MJCF file, with its position in the text, and findings about elements.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::xml {

/// An element of an MJCF file or of a file that it includes.
struct XmlElement {
  std::string tag;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlElement> children;
  diag::SourceMark mark;
  /// Unique name that is added for MuJoCo if the element has no name in the file; otherwise empty.
  std::string generated_name;

  /// Returns the value of an attribute; null if the element does not have the attribute.
  const std::string* Find(std::string_view attribute) const;
  void Set(std::string_view attribute, std::string value);
  void Remove(std::string_view attribute);
  /// Returns the element's name in the file; an empty text if the element has no name.
  std::string Name() const;
  /// Returns "geom 'head'", or "the geom on line 7" if the element has no name.
  std::string Description() const;
};

/// Add an error or a warning with a note at `place` in the MJCF file, and return the finding, so
/// that the caller can set the finding's own place in the spec.
diag::Finding& AddError(diag::Findings& findings, diag::Code code, diag::SourceMark place,
                        std::string message, std::string hint = {});
diag::Finding& AddWarning(diag::Findings& findings, diag::Code code, diag::SourceMark place,
                          std::string message, std::string hint = {});

}  // namespace mjforge::xml
