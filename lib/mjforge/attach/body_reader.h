#pragma once

#include "mjforge/attach/asset_reader.h"
#include "mjforge/attach/compiled_file.h"
#include "mjforge/attach/taken.h"

namespace mjforge::attach {

/// Fills Attachment::bodies and root_joints, and the assets they use.
void ReadBodies(const CompiledFile& file, Taken& taken, AssetReader& assets, model::Attachment& out,
                diag::Findings& findings);

}  // namespace mjforge::attach
