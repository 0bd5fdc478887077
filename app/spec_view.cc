// The view of a spec in pictures: directions and pose.
#include "spec_view.h"

namespace mjforge::app {

picture::View ViewOf(const spec::ObjectSpec& spec, picture::View chosen) {
  if (!chosen.azimuth) chosen.azimuth = spec.view.azimuth;
  if (!chosen.elevation) chosen.elevation = spec.view.elevation;
  return chosen;
}

void SetPoseOf(const spec::ObjectSpec& spec, picture::Subject& subject, diag::Findings& findings) {
  diag::Findings found;
  for (const auto& [name, position] : spec.view.pose) {
    if (const auto joint = subject.FindJoint(name, found))
      subject.SetJoint(*joint, position, found);
  }
  for (const diag::Finding& finding : found)
    findings.Warn(finding.code, spec.view.mark, "the view's pose: " + finding.message,
                  finding.hint);
}

}  // namespace mjforge::app
