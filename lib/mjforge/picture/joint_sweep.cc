// Poses for an animation that moves the joints of a subject through their ranges, one after the
// other.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "mjforge/picture/subject.h"

namespace mjforge::picture {
namespace {

constexpr int kFramesPerWay = 12;  // number of frames of a motion between two positions

// Appends poses that move a joint from `from` to `to`, with a lower speed towards both ends. Omits
// `to`, because the next motion starts with that position.
void AppendWay(int joint, double from, double to, std::vector<JointPositions>& poses) {
  if (from == to) return;
  for (int i = 0; i < kFramesPerWay; ++i) {
    const double share = (1 - std::cos(std::numbers::pi * i / kFramesPerWay)) / 2;
    poses.push_back({{joint, from + (to - from) * share}});
  }
}

void AppendSweep(int number, const Joint& joint, std::vector<JointPositions>& poses) {
  const double start = joint.value;
  if (joint.limited) {
    AppendWay(number, start, joint.range[1], poses);
    AppendWay(number, joint.range[1], joint.range[0], poses);
    AppendWay(number, joint.range[0], start, poses);
  } else {
    for (int i = 0; i < 3 * kFramesPerWay; ++i)
      poses.push_back({{number, start + 2 * std::numbers::pi * i / (3 * kFramesPerWay)}});
  }
  poses.push_back({{number, start}});
}

}  // namespace

std::vector<JointPositions> Subject::Sweep(std::optional<int> joint,
                                           diag::Findings& findings) const {
  std::vector<JointPositions> poses;
  const std::vector<Joint> all = joints();
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const Joint& each = all[static_cast<std::size_t>(i)];
    if ((!joint || *joint == i) && each.IsMovable() && compiled::RangeOf(*state_->model, i))
      AppendSweep(i, each, poses);
  }
  if (poses.empty()) {
    findings.Add(diag::Code::kPictureBadJointValue, {},
                 joint ? fmt::format("joint '{}' has no range to move through",
                                     all[static_cast<std::size_t>(*joint)].name)
                       : "no joint has a range to move through");
  }
  return poses;
}

}  // namespace mjforge::picture
