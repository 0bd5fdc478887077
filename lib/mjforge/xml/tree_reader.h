// Reader of an MJCF file and the files that it includes as one tree of elements.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/xml/element.h"

namespace mjforge::xml {

/// Returns the canonical path of a file. All paths of the same file have the same canonical path.
std::string CanonicalName(const std::filesystem::path& file);

/// Returns the root element of an MJCF file, with the contents of included files in place of the
/// includes. Adds the texts of all files to `sources`. Returns nullopt, after adding findings, if
/// there is an error. The findings have notes that refer to places in the XML; the caller sets the
/// findings' own places, which are in the spec.
std::optional<XmlElement> ReadXml(const std::filesystem::path& file, diag::Sources& sources,
                                  diag::Findings& findings);

}  // namespace mjforge::xml
