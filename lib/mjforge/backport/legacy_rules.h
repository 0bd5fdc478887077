// Changes files so that they meet requirements that MuJoCo dropped in later releases.
#pragma once

#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// Changes the tree so that the release `version` (a mjVERSION_HEADER) accepts it: sets
/// `autolimits` if there are ranges without `limited`, moves actuators with an activation state
/// behind the others, and copies an inherited `ctrlrange` into actuators that require it. Returns
/// true if the tree changed.
bool ApplyLegacyRules(xml::XmlElement& root, int version);

}  // namespace mjforge::backport
