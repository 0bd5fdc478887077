// Reads an MJCF file and the files that it includes as one tree of elements.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/xml/element.h"

namespace mjforge::xml {

/// Returns the canonical path of a file, which is the same for all paths to the file.
std::string CanonicalName(const std::filesystem::path& file);

/// Reads the file and all files that it includes into `sources`. Returns nullopt after an error.
/// Findings have notes with places in the XML; the caller sets the findings' own places.
std::optional<XmlElement> ReadXml(const std::filesystem::path& file, diag::Sources& sources,
                                  diag::Findings& findings);

}  // namespace mjforge::xml
