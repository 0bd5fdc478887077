// Reads an MJCF file and the files that it includes as one tree of elements.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/xml/element.h"

namespace mjforge::xml {

/// Returns the canonical path of a file. All paths of the same file have the same canonical path.
std::string CanonicalName(const std::filesystem::path& file);

/// Reads an MJCF file and all files that it includes into `sources`. Returns nullopt, after adding
/// findings, if there is an error. The findings have notes with places in the XML; the caller sets
/// the findings' own places.
std::optional<XmlElement> ReadXml(const std::filesystem::path& file, diag::Sources& sources,
                                  diag::Findings& findings);

}  // namespace mjforge::xml
