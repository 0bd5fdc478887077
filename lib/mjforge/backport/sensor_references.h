// Check of the names that sensors refer to.
#pragma once

#include "mjforge/diag/diag.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// Adds an error for each name in a sensor that no element of the file has. Every release of MuJoCo
/// rejects such a file, but a backport that removes the sensor would hide the mistake. Checks
/// nothing in files with elements that MuJoCo expands, because the expansion creates names.
void CheckReferences(const xml::XmlElement& sensor, const xml::XmlElement& root,
                     const diag::Sources& sources, diag::Findings& findings);

}  // namespace mjforge::backport
