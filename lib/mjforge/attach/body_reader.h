// Reader of the bodies of an attachment, a body of an MJCF file for use in a spec.
#pragma once

#include "mjforge/attach/asset_reader.h"
#include "mjforge/attach/compiled_file.h"
#include "mjforge/attach/name_scope.h"

namespace mjforge::attach {

/// Adds the bodies of `scope`, with their joints, geoms and other elements, to Attachment::bodies
/// and root_joints. Adds the meshes and materials of these bodies to `assets`.
void ReadBodies(const CompiledFile& file, NameScope& scope, AssetReader& assets,
                model::Attachment& out, diag::Findings& findings);

}  // namespace mjforge::attach
