// Check for joint ranges that are too large for real joints.
#include "mjforge/physics/model_checks.h"

#include <numbers>
#include <string>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/physics/joint_couplings.h"

namespace mjforge::physics {
namespace {

using diag::Code;
using expr::ExceededLimit;

// Relative tolerance for rounding errors, because a spec may compute limit and range from the same
// parameter.
constexpr double kSameRange = 1e-6;

}  // namespace

double LongestSlide(const model::Object& object, const model::Checks& checks) {
  const model::Box3& box = object.bounds.aabb;
  const double size = box.empty() ? 0 : (box.max - box.min).maxCoeff();
  return size > 0 ? checks.slide_range * size : std::numeric_limits<double>::infinity();
}

void CheckRanges(const ModelTest& test) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const mjModel& m = test.m;
  const model::Checks& checks = test.checks();
  const JointCouplings couplings(m);
  const double longest = LongestSlide(test.object, checks);
  for (int joint = 0; joint < m.njnt; ++joint) {
    if (m.jnt_limited[joint] == 0 || couplings.IsCoupled(joint)) continue;
    const std::string name = test.JointName(joint);
    const double range = (m.jnt_range[2 * joint + 1] - m.jnt_range[2 * joint]) * (1 - kSameRange);
    if (m.jnt_type[joint] == mjJNT_HINGE && range > checks.hinge_range) {
      const ExceededLimit beyond(kDegrees * range, kDegrees * checks.hinge_range);
      test.reporter.Warning(Code::kPhysicsJointRange, test.JointMark(name),
                            fmt::format("joint '{}' turns by {} deg, more than {} deg", name,
                                        beyond.value, beyond.limit),
                            "angles are in radians; a screw or a valve sets checks.hinge_range");
    }
    if (m.jnt_type[joint] == mjJNT_SLIDE && range > longest) {
      const ExceededLimit beyond(1000 * range, 1000 * longest);
      test.reporter.Warning(
          Code::kPhysicsJointRange, test.JointMark(name),
          fmt::format("joint '{}' slides by {} mm, more than {} mm, {} times the "
                      "object's size",
                      name, beyond.value, beyond.limit, expr::RoundedText(checks.slide_range)),
          "lengths are in metres; a crane sets checks.slide_range");
    }
  }
}

}  // namespace mjforge::physics
