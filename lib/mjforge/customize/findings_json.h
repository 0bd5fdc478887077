// Findings as JSON for the page of `mjforge customize`.

#pragma once

#include "mjforge/diag/diag.h"

namespace mjforge::customize {

/// Writes the member `findings`, a list of at most 50 objects: `finding` as in `--findings json`,
/// and `text`, the line of the file to which the finding refers.
void WriteFindings(diag::Json& json, diag::Findings findings, const diag::Sources& sources);

}  // namespace mjforge::customize
