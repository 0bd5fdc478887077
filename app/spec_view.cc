// Camera directions and pose that a spec chooses for its pictures (`view:`).
#include "spec_view.h"

namespace mjforge::app {

picture::View ViewOf(const spec::ObjectSpec& spec, picture::View chosen) {
  if (!chosen.azimuth) chosen.azimuth = spec.view.azimuth;
  if (!chosen.elevation) chosen.elevation = spec.view.elevation;
  return chosen;
}

void SetPoseOf(const spec::ObjectSpec& spec, picture::Subject& subject, diag::Findings& findings) {
  for (const spec::PictureView::Position& position : spec.view.pose) {
    diag::Findings unknown;
    diag::Findings found;
    if (const auto joint = subject.FindJoint(position.joint, unknown))
      subject.SetJoint(*joint, position.value, found);
    for (const diag::Finding& finding : found)
      findings.Warn(finding.code, position.mark, "the view's pose: " + finding.message,
                    finding.hint);
  }
}

}  // namespace mjforge::app
