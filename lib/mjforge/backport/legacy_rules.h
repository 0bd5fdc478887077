// Requirements of older MuJoCo releases that every file must meet.
#pragma once

#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// Changes the tree so that it meets requirements that later releases dropped: `autolimits` for
/// ranges without `limited`, actuators with a state last, and `ctrlrange` in the actuator itself.
/// Returns true if the tree changed. `version` is a mjVERSION_HEADER.
bool ApplyLegacyRules(xml::XmlElement& root, int version);

}  // namespace mjforge::backport
