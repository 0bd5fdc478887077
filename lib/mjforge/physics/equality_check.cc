// Reports equality constraints that slip while the joints that they couple are driven.
#include "mjforge/physics/model_checks.h"

#include <string>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/physics/equality_drive.h"

namespace mjforge::physics {
namespace {

using expr::RoundedText;

std::string MessageOf(const ModelTest& test, const EqualityDrive& drive) {
  const mjModel& m = test.m;
  const bool is_of_joints = m.eq_type[drive.equality] == mjEQ_JOINT;
  const int first = m.eq_obj1id[drive.equality];
  const double error = drive.measured.error;
  return fmt::format(
      "equality '{}' slips by {}, {} % of {}, as joint '{}' is driven", drive.measured.name,
      is_of_joints ? test.Distance(first, error) : fmt::format("{} mm", RoundedText(1000 * error)),
      RoundedText(100 * drive.measured.share),
      is_of_joints ? fmt::format("the way of joint '{}'", test.JointName(first))
                   : "the object's size",
      test.JointName(drive.driven));
}

std::string RemedyOf(const ModelTest& test, const EqualityDrive& drive) {
  const mjModel& m = test.m;
  const int first = m.eq_obj1id[drive.equality];
  if (drive.outside_joint >= 0 && drive.outside_error >= drive.measured.error / 2) {
    return fmt::format(
        "joint '{}' would have to go {} beyond its range: look at the range, and at the ratio, "
        "which "
        "is m or rad for each m or rad of the other joint, not for each turn",
        test.JointName(drive.outside_joint), test.Distance(drive.outside_joint, drive.outside));
  }
  if (drive.is_reversed) {
    const mjtNum* poly = m.eq_data + mjNEQDATA * drive.equality;
    return fmt::format(
        "exchange the joints: `joint1: {}, joint2: {}, polycoef: [{}, {}, 0, 0, 0]`; MuJoCo makes "
        "an equality as soft as the lighter joint needs, which must be joint1",
        test.JointName(m.eq_obj2id[drive.equality]), test.JointName(first),
        poly[0] == 0 ? "0" : RoundedText(-poly[0] / poly[1]), RoundedText(1 / poly[1]));
  }
  return "bring solimp closer to 1 (`solimp: [0.99, 0.999, 0.001]`), give the lighter joint an "
         "armature, or look for something in the way";
}

}  // namespace

void CheckEqualities(const ModelTest& test) {
  for (const EqualityDrive& drive :
       DriveEqualities(test.m, test.workspace.For(test.m), test.object.name, test.checks())) {
    test.result.equalities.push_back(drive.measured);
    if (!(drive.measured.share > test.checks().equality_error)) continue;
    test.reporter.Error(diag::Code::kPhysicsEqualitySlips,
                        test.ElementMark("equality", drive.measured.name), MessageOf(test, drive),
                        RemedyOf(test, drive));
  }
}

}  // namespace mjforge::physics
