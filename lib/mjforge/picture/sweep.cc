#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "mjforge/picture/subject.h"

namespace mjforge::picture {
namespace {

constexpr int kFramesPerWay = 12;  // from one place to the next

// Slower towards both ends. The last place itself is the next way's first.
void AppendWay(int joint, double from, double to, std::vector<Pose>& poses) {
  if (from == to) return;
  for (int i = 0; i < kFramesPerWay; ++i) {
    const double share = (1 - std::cos(std::numbers::pi * i / kFramesPerWay)) / 2;
    poses.push_back({{joint, from + (to - from) * share}});
  }
}

void AppendSweep(int number, const Joint& joint, std::vector<Pose>& poses) {
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

std::vector<Pose> Subject::Sweep(std::optional<int> joint, diag::Findings& findings) const {
  std::vector<Pose> poses;
  const std::vector<Joint> all = joints();
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const Joint& each = all[static_cast<std::size_t>(i)];
    const bool can_move = each.type == Joint::Type::kHinge || each.type == Joint::Type::kSlide;
    if ((!joint || *joint == i) && can_move && compiled::RangeOf(*state_->model, i))
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
