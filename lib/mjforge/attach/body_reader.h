// Reads the bodies of an attachment from the compiled model.
#pragma once

#include "mjforge/attach/asset_reader.h"
#include "mjforge/attach/compiled_file.h"
#include "mjforge/attach/name_scope.h"

namespace mjforge::attach {

/// Fills Attachment::bodies and root_joints, and adds the assets that they use.
void ReadBodies(const CompiledFile& file, NameScope& scope, AssetReader& assets,
                model::Attachment& out, diag::Findings& findings);

}  // namespace mjforge::attach
