// Findings as JSON for the page.

#pragma once

#include "mjforge/diag/diag.h"

namespace mjforge::customize {

/// Writes a list of objects: each finding as in `--findings json`, and `text`, the line of its
/// place. The list has at most 50 findings.
void WriteFindings(diag::Json& json, diag::Findings findings, const diag::Sources& sources);

}  // namespace mjforge::customize
