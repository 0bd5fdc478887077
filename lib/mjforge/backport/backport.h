// Backport of MJCF: rewrites files so that they have the same meaning in an older MuJoCo.
#pragma once

#include "mjforge/backport/key_limits.h"
#include "mjforge/backport/later_rules.h"
#include "mjforge/backport/mesh_inertia.h"
#include "mjforge/backport/model_file.h"
#include "mjforge/backport/refused_attributes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// The release that mjforge writes files for, as mjVERSION_HEADER: 2.2.2.
inline constexpr int kPortable = 222;

/// The purpose for which a file is backported.
enum class Use {
  kWholeModel,
  kBodies,  // attaching: settings of the whole model (`option`, `visual`, ...) are not used
};

/// Changes the tree so that it means the same in release `version` (a mjVERSION_HEADER), and
/// returns true if the tree changed. Ranges apply without `limited`, as in MuJoCo 3.0 and later.
/// Replaces elements and attributes of later releases by equivalent older ones. If there are none,
/// removes features that affect only pictures or how a model is computed, with a warning; any other
/// feature is an error. Reports each attribute once per file, at its first place. With kWholeModel,
/// warns of attributes that releases after `version` reject. With kBodies, frames and replicates
/// stay in the tree if the MuJoCo of this build expands them.
bool BackportMjcf(xml::XmlElement& root, int version, Use use, const diag::Sources& sources,
                  diag::Findings& findings);

}  // namespace mjforge::backport
