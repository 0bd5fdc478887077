// Camera directions and pose that a spec chooses for its pictures (`view:`).
#include "spec_view.h"

#include <fmt/format.h>

namespace mjforge::app {

picture::View ViewOf(const spec::ObjectSpec& spec, picture::View chosen) {
  if (!chosen.azimuth) chosen.azimuth = spec.view.azimuth;
  if (!chosen.elevation) chosen.elevation = spec.view.elevation;
  return chosen;
}

bool IsInUnitOf(const picture::Joint& joint, expr::Dimension dimension, diag::Findings& findings) {
  const expr::Dimension own = joint.type == picture::Joint::Type::kHinge ? expr::Dimension::Angle()
                                                                         : expr::Dimension(1, 0, 0);
  if (!joint.IsMovable() || dimension.is_plain() || dimension == own) return true;
  findings.Add(diag::Code::kPictureBadJointValue, {},
               fmt::format("joint '{}' is in {}, but its position is given in {}", joint.name,
                           own.Text(), dimension.Text()));
  return false;
}

void SetPoseOf(const spec::ObjectSpec& spec, picture::Subject& subject, diag::Findings& findings) {
  for (const spec::PictureView::Position& position : spec.view.pose) {
    diag::Findings unknown;
    diag::Findings found;
    const auto joint = subject.FindJoint(position.joint, unknown);
    // The assembly has warned of a position in another unit.
    if (joint && IsInUnitOf(subject.joints()[*joint], position.dimension, unknown))
      subject.SetJoint(*joint, position.value, found);
    for (const diag::Finding& finding : found)
      findings.Warn(finding.code, position.mark, "the view's pose: " + finding.message,
                    finding.hint);
  }
}

}  // namespace mjforge::app
