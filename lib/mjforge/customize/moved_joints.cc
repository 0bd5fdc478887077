// Setting of joint positions for the picture on the page of `mjforge customize`: first the base
// pose, then the joints that the page has moved.
#include "mjforge/customize/moved_joints.h"

#include <algorithm>

namespace mjforge::customize {
namespace {

// Moves all joints to the base pose of the request. A joint that cannot reach its position in the
// pose of `view:` stays at its start.
void MoveToBase(const Request& request, ShownVariant& shown) {
  picture::Subject& subject = *shown.subject;
  subject.Reset(request.pose == BasePose::kZero ? picture::Pose::kZero : picture::Pose::kStart);
  if (request.pose != BasePose::kView) return;
  diag::Findings ignored;  // unknown names were already reported when the object was made
  for (const spec::PictureView::Position& position : shown.recipe->spec->view.pose) {
    const std::optional<int> joint = subject.FindJoint(position.joint, ignored);
    if (joint) subject.SetJoint(*joint, position.value, ignored);
  }
}

}  // namespace

void MoveJoints(const Request& request, ShownVariant& shown) {
  diag::Findings ignored;  // remains empty, because all values are within the joints' ranges
  MoveToBase(request, shown);
  shown.joints = shown.subject->joints();
  for (std::size_t i = 0; i < shown.joints.size(); ++i) {
    const picture::Joint& joint = shown.joints[i];
    if (!joint.IsMovable()) continue;
    const auto wanted =
        std::ranges::find(request.joints, joint.name, &std::pair<std::string, double>::first);
    if (wanted == request.joints.end()) continue;
    double value = wanted->second;
    if (joint.limited) value = std::clamp(value, joint.range[0], joint.range[1]);
    shown.subject->SetJoint(static_cast<int>(i), value, ignored);
  }
}

}  // namespace mjforge::customize
