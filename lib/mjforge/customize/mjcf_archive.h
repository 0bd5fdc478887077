// Tar archive of an MJCF file and the files to which the MJCF file refers.

#pragma once

#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"

namespace mjforge::customize {

/// Sets `archive` to the bytes of a tar archive with the folder `name`, which contains `name`.xml
/// and the files to which this MJCF refers. Returns false, and adds a finding, if a file cannot be
/// read.
bool ArchiveMjcf(const std::string& name, const mjcf::MjcfDocument& document, std::string& archive,
                 diag::Findings& findings);

}  // namespace mjforge::customize
