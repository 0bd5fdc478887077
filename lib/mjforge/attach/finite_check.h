// Check that all numbers of an attachment (a body of an MJCF file, for use in a spec) are finite.
#pragma once

#include <filesystem>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::attach {

/// Reports an error for each number that is not finite. MuJoCo accepts NaN and infinity in many
/// places without a warning.
void CheckFinite(const model::Attachment& attachment, const std::filesystem::path& file,
                 diag::Findings& findings);

}  // namespace mjforge::attach
