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
  kBodies,  // to attach the bodies, without settings of the model (`option`, `visual`, ...)
};

/// Changes a tree of MJCF elements so that release `version` (a mjVERSION_HEADER) understands the
/// file, with its meaning in later releases; returns true if the tree changed. In the original,
/// ranges apply without `limited`, as in MuJoCo 3.0 and later. Replaces elements and attributes of
/// later releases by equivalent older ones. If there are none, removes features that affect only
/// pictures or how a model is computed, with a warning, and adds an error for any other feature.
/// Reports each attribute once per file, where the attribute first occurs. With kWholeModel, warns
/// of attributes that releases after `version` reject. With kBodies, keeps `<frame>` and
/// `<replicate>` if the MuJoCo of this build expands them.
bool BackportMjcf(xml::XmlElement& root, int version, Use use, const diag::Sources& sources,
                  diag::Findings& findings);

}  // namespace mjforge::backport
