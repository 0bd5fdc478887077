// Check of the positions of joints at rest, against their ranges and `rests` of checks.joints.
#include "mjforge/physics/joint_rest.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/causes.h"
#include "mjforge/physics/joint_checks.h"
#include "mjforge/physics/model_checks.h"

namespace mjforge::physics {
namespace {

// Distances by which joints may exceed their ranges, because limits are soft. Under weight, a limit
// with the default solreflimit gives way by about 0.4 mm.
constexpr double kSagOfSlide = 0.001;  // m
constexpr double kSagOfHinge = 0.02;   // rad
// Largest speeds of a joint that creeps. A faster joint rolls or swings.
constexpr double kCreepOfSlide = 0.01;  // m/s
constexpr double kCreepOfHinge = 0.1;   // rad/s
// Time in which a moving joint must not leave the positions that `rests` allows.
constexpr double kSoon = 10;  // s

/// A hinge or slide outside its range, or outside `rests`, at the end of a drop.
struct JointOffRange {
  int joint = 0;
  double position = 0;  // rad or m, value in qpos
  double low = 0;       // ends of the allowed positions
  double high = 0;
  double beyond = 0;                         // distance from allowed positions, now or in 10 s
  const model::JointCheck* check = nullptr;  // entry with the violated `rests`; null: range
  double speed = 0;  // rad/s or m/s, if the joint leaves `rests` only within 10 s; else 0
};

std::vector<JointOffRange> FindJointsOffRange(const ModelTest& test, const mjData& d) {
  const mjModel& m = test.m;
  const model::Checks& checks = test.checks();
  const JointChecks entries(m, test.object.name, checks);
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

std::string_view ForceUnit(const mjModel& m, int joint) {
  return m.jnt_type[joint] == mjJNT_SLIDE ? "N" : "Nm";
}

/// Returns the force that the dry friction of a joint must bear to hold the joint, N or Nm.
double LoadOf(const mjModel& m, const mjData& d, int joint) {
  const int dof = m.jnt_dofadr[joint];
  return std::abs(d.qfrc_bias[dof] - d.qfrc_passive[dof] - d.qfrc_actuator[dof]);
}

/// Returns the allowed positions as a text: "A to B".
std::string Allowed(const ModelTest& test, const JointOffRange& off_range) {
  return fmt::format("{} to {}", test.Distance(off_range.joint, off_range.low),
                     test.Distance(off_range.joint, off_range.high));
}

std::string OffRangeMessage(const ModelTest& test, const JointOffRange& off_range) {
  const int joint = off_range.joint;
  const std::string name = test.JointName(joint);
  const std::string position = test.Distance(joint, off_range.position);
  if (off_range.speed != 0) {
    return fmt::format(
        "joint '{}' is at {} and still moves, by {} in a second: it leaves where `rests` has it, "
        "{}",
        name, position, test.Distance(joint, off_range.speed), Allowed(test, off_range));
  }
  return fmt::format("joint '{}' rests at {}, {} beyond {}, {}", name, position,
                     test.Distance(joint, off_range.beyond),
                     off_range.check != nullptr ? "where `rests` has it" : "its range",
                     Allowed(test, off_range));
}

std::string OffRangeRemedy(const mjModel& m, const mjData& d, const JointOffRange& off_range) {
  const int joint = off_range.joint;
  if (off_range.check == nullptr) {
    return LimitHint(
        m, joint, off_range.beyond,
        "a spring or weight presses it: use a harder limit (a smaller solreflimit), or "
        "a softer spring");
  }
  const double friction = m.dof_frictionloss[m.jnt_dofadr[joint]];
  const double load = LoadOf(m, d, joint);
  if (friction > 0 && friction < load) {
    const std::string_view unit = ForceUnit(m, joint);
    return fmt::format("its dry friction of {} {} cannot hold the {} {} that pull at it there",
                       expr::RoundedText(friction), unit, expr::RoundedText(load), unit);
  }
  std::string creep = CreepRemedy(m, d, joint);
  if (!creep.empty()) return creep;
  return off_range.speed != 0
             ? "hold it by a spring or dry friction, or, if it comes to rest later, set a longer "
               "`settle_time`"
             : "look at springs, `springref`, dry friction, and weight; a limit of the range gives "
               "way a little, too; if it comes to rest later, set a longer `settle_time`";
}

}  // namespace

bool HasRestRanges(const model::Checks& checks) {
  return std::ranges::any_of(
      checks.joints, [](const model::JointCheck& check) { return check.rests.has_value(); });
}

std::string CreepRemedy(const mjModel& m, const mjData& d, int joint) {
  const int dof = m.jnt_dofadr[joint];
  const double speed = std::abs(d.qvel[dof]);
  const double most = m.jnt_type[joint] == mjJNT_SLIDE ? kCreepOfSlide : kCreepOfHinge;
  if (!(m.dof_frictionloss[dof] > LoadOf(m, d, joint)) || speed == 0 || speed > most) return {};
  return fmt::format(
      "its dry friction of {} {} would hold it, but MuJoCo's friction is soft and creeps: bring "
      "solimpfriction closer to 1 (`solimpfriction: [0.99, 0.9999, 0.001]`), or give the joint an "
      "`armature`",
      expr::RoundedText(m.dof_frictionloss[dof]), ForceUnit(m, joint));
}

void CheckJointRests(const ModelTest& test, const mjData& d) {
  for (const JointOffRange& off_range : FindJointsOffRange(test, d)) {
    test.reporter.Error(diag::Code::kPhysicsJointRests,
                        off_range.check != nullptr
                            ? off_range.check->mark
                            : test.JointMark(test.JointName(off_range.joint)),
                        OffRangeMessage(test, off_range), OffRangeRemedy(test.m, d, off_range));
  }
}

}  // namespace mjforge::physics
