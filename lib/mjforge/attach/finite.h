#pragma once

#include <filesystem>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::attach {

/// In many places MuJoCo silently loads NaN and infinity; here each is an error.
void CheckFinite(const model::Attachment& attachment, const std::filesystem::path& file,
                 diag::Findings& findings);

}  // namespace mjforge::attach
