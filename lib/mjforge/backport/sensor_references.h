// Finds sensors that refer to elements that do not exist.
#pragma once

#include "mjforge/diag/diag.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// Adds an error for each name to which a sensor refers and that no element of the file has. MuJoCo
/// would reject such a file, but a backport that removes the sensor would hide the mistake. Checks
/// nothing in files with elements that MuJoCo expands, because the expansion creates names.
void CheckReferences(const xml::XmlElement& sensor, const xml::XmlElement& root,
                     const diag::Sources& sources, diag::Findings& findings);

}  // namespace mjforge::backport
