// A temporary folder for files that another program reads.
#pragma once

#include <filesystem>
#include <memory>

#include "mjforge/diag/diag.h"

namespace mjforge::app {

/// Makes a temporary folder that only this user can read. The folder is removed with the last copy
/// of the returned pointer. Returns null and adds a finding on failure.
std::shared_ptr<const std::filesystem::path> MakeTemporaryFolder(diag::Findings& findings);

}  // namespace mjforge::app
