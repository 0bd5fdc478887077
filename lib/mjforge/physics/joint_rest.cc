// Joints that rest outside their range, or outside the positions that `rests` of the spec allows.
#include "mjforge/physics/joint_rest.h"

#include <algorithm>

#include "mjforge/compiled/compiled.h"
#include "mjforge/physics/joint_checks.h"

namespace mjforge::physics {
namespace {

// Tolerances of limits, which give way under weight, by about 0.4 mm with the default solreflimit.
constexpr double kSagOfSlide = 0.001;  // m
constexpr double kSagOfHinge = 0.02;   // rad
// A joint that creeps violates `rests` if it leaves the allowed positions within this time.
constexpr double kSoon = 10;  // s

}  // namespace

bool HasRestRanges(const model::Checks& checks) {
  return std::ranges::any_of(
      checks.joints, [](const model::JointCheck& check) { return check.rests.has_value(); });
}

std::vector<JointOffRange> FindJointsOffRange(const mjModel& m, const mjData& d,
                                              std::string_view object,
                                              const model::Checks& checks) {
  const JointChecks entries(m, object, checks);
  std::vector<JointOffRange> all;
  for (int joint = 0; joint < m.njnt; ++joint) {
    if (!compiled::HasOneNumber(m, joint)) continue;
    const double position = d.qpos[m.jnt_qposadr[joint]];
    const auto look = [&](double low, double high, double slack, const model::JointCheck* check) {
      const auto beyond = [&](double where) { return std::max(low - where, where - high); };
      const double speed = d.qvel[m.jnt_dofadr[joint]];
      const double soon = beyond(position + kSoon * speed);
      if (beyond(position) > slack) {
        all.push_back({joint, position, low, high, beyond(position), check});
      } else if (check != nullptr && soon > 0) {
        all.push_back({joint, position, low, high, soon, check, speed});
      }
    };
    double slack = checks.joint_overshoot;
    for (const model::JointCheck& check : checks.joints) {
      if (!entries.Names(check, joint)) continue;
      slack = check.overshoot.value_or(slack);
      if (check.rests) look(check.rests->x(), check.rests->y(), 0, &check);
    }
    const double low = m.jnt_range[2 * joint];
    const double high = m.jnt_range[2 * joint + 1];
    const double sag = m.jnt_type[joint] == mjJNT_SLIDE ? kSagOfSlide : kSagOfHinge;
    if (m.jnt_limited[joint] != 0) look(low, high, slack * (high - low) + sag, nullptr);
  }
  return all;
}

}  // namespace mjforge::physics
