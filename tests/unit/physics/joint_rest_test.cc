// Joints that creep, and what to do about them.
#include "examined.h"

namespace mjforge::physics {
namespace {

/// A lid on a hinge with this dry friction (Nm), which must stay where it starts.
Examined Lid(const std::string& joint) {
  model::Checks checks;
  checks.joints = {{.joints = {"lid"}, .rests = Eigen::Vector2d(0.9, 1.2)}};
  return Examine(
      Free(0.008, R"(<geom type="box" size="0.15 0.1 0.008"/>
    <body name="screen" pos="0 0.1 0.012"><joint name="lid" axis="-1 0 0" limited="true"
      range="0 2.2" damping="0.05" )" +
                      joint +
                      R"(/><geom type="box" size="0.15 0.1 0.003" pos="0 -0.1 0"/></body>)"),
      R"(<keyframe><key name="m_start" qpos="0 0 0.008 1 0 0 0 1.05"/></keyframe>)", checks);
}

std::string HintOf(const Examined& examined, diag::Code code) {
  for (const diag::Finding& finding : examined.findings)
    if (finding.code == code) return finding.hint;
  return {};
}

}  // namespace

TEST_CASE("a joint that creeps against enough dry friction needs a harder one") {
  const Examined creeps = Lid(R"(frictionloss="50")");
  const std::string hint = HintOf(creeps, diag::Code::kPhysicsJointRests);
  CHECK(hint ==
        "its dry friction of 50 Nm would hold it, but MuJoCo's friction is soft and creeps: bring "
        "solimpfriction closer to 1 (`solimpfriction: [0.99, 0.9999, 0.001]`), or give the joint "
        "an `armature`");
  CHECK(HintOf(creeps, diag::Code::kPhysicsNotAtRest) == hint);
}

TEST_CASE("the remedies against creeping work") {
  CHECK(Lid(R"(frictionloss="50" solimpfriction="0.99 0.9999 0.001")").Codes().empty());
  CHECK(Lid(R"(frictionloss="50" armature="1")").Codes().empty());
}

}  // namespace mjforge::physics
