// Gains of actuators that come from default classes, which releases of MuJoCo inherit differently.
#pragma once

#include "mjforge/backport/default_classes.h"
#include "mjforge/diag/diag.h"

namespace mjforge::backport {

/// Returns true for the actuators `position` and `intvelocity`, which pull their joint to a
/// position.
bool IsServo(const xml::XmlElement& element);

/// Writes gains that MuJoCo 2.2 drops, and later releases inherit, into the actuators themselves:
/// the `gain` of `<adhesion>`, the `kv` of `<damper>` (inherited since 3.16), and the damping of a
/// servo whose default `<general>` has a `biasprm`. `version`: the release (a mjVERSION_HEADER)
/// that is to read the file. Returns true if the tree changed.
bool WriteInheritedGains(xml::XmlElement& root, int version);

/// Warns of actuators without gains of their own that take the gains of another kind of actuator
/// from a default class, such as a `<velocity>` the `kp` of a default `<position>`. MuJoCo up to
/// 3.15 does so. Adds one warning for each two kinds.
void WarnOfForeignGains(xml::XmlElement& root, int version, diag::Findings& findings);

}  // namespace mjforge::backport
