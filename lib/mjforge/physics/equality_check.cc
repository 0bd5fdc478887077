// Check that equality constraints hold while joints are driven: the texts of its findings.
#include "mjforge/physics/equality_check.h"

#include <string>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/physics/element_marks.h"
#include "mjforge/physics/equality_drive.h"

namespace mjforge::physics {
namespace {

using expr::RoundedText;

std::string JointName(const mjModel& m, int joint) {
  return compiled::NameOf(m, mjOBJ_JOINT, joint);
}

std::string Distance(const mjModel& m, int joint, double value) {
  return expr::DistanceText(m.jnt_type[joint] == mjJNT_SLIDE, value);
}

std::string MessageOf(const mjModel& m, const EqualityDrive& drive) {
  const bool is_of_joints = m.eq_type[drive.equality] == mjEQ_JOINT;
  const int first = m.eq_obj1id[drive.equality];
  const double error = drive.measured.error;
  return fmt::format(
      "equality '{}' slips by {}, {} % of {}, as joint '{}' is driven", drive.measured.name,
      is_of_joints ? Distance(m, first, error) : fmt::format("{} mm", RoundedText(1000 * error)),
      RoundedText(100 * drive.measured.share),
      is_of_joints ? fmt::format("the way of joint '{}'", JointName(m, first))
                   : "the object's size",
      JointName(m, drive.driven));
}

std::string RemedyOf(const mjModel& m, const EqualityDrive& drive) {
  const int first = m.eq_obj1id[drive.equality];
  if (drive.outside_joint >= 0 && drive.outside_error >= drive.measured.error / 2) {
    return fmt::format(
        "joint '{}' would have to go {} beyond its range: look at the range, and at the ratio, "
        "which "
        "is m or rad for each m or rad of the other joint, not for each turn",
        JointName(m, drive.outside_joint), Distance(m, drive.outside_joint, drive.outside));
  }
  if (drive.is_reversed) {
    const mjtNum* poly = m.eq_data + mjNEQDATA * drive.equality;
    return fmt::format(
        "exchange the joints: `joint1: {}, joint2: {}, polycoef: [{}, {}, 0, 0, 0]`; MuJoCo makes "
        "an equality as soft as the lighter joint needs, which must be joint1",
        JointName(m, m.eq_obj2id[drive.equality]), JointName(m, first),
        poly[0] == 0 ? "0" : RoundedText(-poly[0] / poly[1]), RoundedText(1 / poly[1]));
  }
  return "bring solimp closer to 1 (`solimp: [0.99, 0.999, 0.001]`), give the lighter joint an "
         "armature, or look for something in the way";
}

}  // namespace

void CheckEqualities(const mjModel& m, Workspace& workspace, const model::Object& object,
                     diag::SourceMark mark, static_checks::Reporter& reporter, Result& result) {
  const model::Checks& checks = reporter.checks();
  for (const EqualityDrive& drive : DriveEqualities(m, workspace.For(m), object.name, checks)) {
    result.equalities.push_back(drive.measured);
    if (!(drive.measured.share > checks.equality_error)) continue;
    reporter.Error(diag::Code::kPhysicsEqualitySlips,
                   ElementMark(object, "equality", drive.measured.name, mark), MessageOf(m, drive),
                   RemedyOf(m, drive));
  }
}

}  // namespace mjforge::physics
