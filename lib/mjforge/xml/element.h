// An element of an MJCF file with its place in the text, and findings that refer to such places.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::xml {

/// An element of an MJCF file or of a file that it includes.
struct XmlElement {
  std::string tag = {};
  std::vector<std::pair<std::string, std::string>> attributes = {};
  std::vector<XmlElement> children = {};
  diag::SourceMark mark = {};
  /// Unique name that is added for MuJoCo if the element has no name in the file; otherwise empty.
  std::string generated_name = {};

  /// Returns the value of an attribute; null if the element does not have the attribute.
  const std::string* Find(std::string_view attribute) const;
  void Set(std::string_view attribute, std::string value);
  void Remove(std::string_view attribute);
  /// Returns the element's name in the file; an empty text if the element has no name.
  std::string Name() const;
  /// Returns Name() or, if it is empty, the name that MuJoCo gives an asset: that of its file.
  std::string AssetName() const;
  /// Returns "geom 'head'", or "the geom on line 7" if the element has no name.
  std::string Description() const;
};

/// Add an error or a warning with a note that refers to `place` in the MJCF file. Return the
/// finding; the caller sets the finding's own place, which is in the spec.
diag::Finding& AddError(diag::Findings& findings, diag::Code code, diag::SourceMark place,
                        std::string message, std::string hint = {});
diag::Finding& AddWarning(diag::Findings& findings, diag::Code code, diag::SourceMark place,
                          std::string message, std::string hint = {});

}  // namespace mjforge::xml
