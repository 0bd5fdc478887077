// Tar archive of an MJCF file and the files that it refers to.

#pragma once

#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"

namespace mjforge::customize {

/// Makes an archive with the folder `name`, which contains `name`.xml and the files that this MJCF
/// refers to. Returns false, and adds a finding, if a file cannot be read.
bool ArchiveMjcf(const std::string& name, const mjcf::MjcfDocument& document, std::string& archive,
                 diag::Findings& findings);

}  // namespace mjforge::customize
