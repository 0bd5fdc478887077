// Writes the MJCF of the gripper, places the gripper, and reads its contacts.
#include "mjforge/physics/gripper.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/physics/probe_bodies.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {
namespace {

using Eigen::Vector3d;

// Half sides of a finger, m. Faces of 20 x 20 mm and a length of 55 mm are typical of robots.
const Vector3d kFinger(0.01, 0.005, 0.0275);
constexpr double kTip = 0.01;         // m, length of the fingers beyond the origin
constexpr double kPalm = 0.01;        // m, half height of the palm
constexpr double kClearance = 0.002;  // m, gap between fingers and palm, so that they do not rub
constexpr double kFingerMass = 0.1;   // kg
// Armature of a finger, kg, typical of a geared drive. The stiffness of MuJoCo's contacts is
// proportional to the masses that they move, so that light fingers would press through a plate.
constexpr double kArmature = 0.5;
constexpr double kSpeed = 0.1;  // m/s, speed at which the jaws close
// Contact attributes of the jaws, which are of slightly soft rubber.
constexpr std::string_view kRubber = R"(condim="4" friction="1 0.01 0.0001")";

std::string PartName(std::string_view part) { return fmt::format("{}{}", kProbePrefix, part); }

std::string Finger(int side, const model::GraspingCheck& grasping) {
  const int sign = side == 0 ? 1 : -1;
  const std::string box =
      fmt::format(R"(type="box" size="{} {} {}" pos="0 {} {}")", kFinger.x(), kFinger.y(),
                  kFinger.z(), sign * kFinger.y(), kTip - kFinger.z());
  return fmt::format(
      R"(<body name="{}"><joint name="{}" type="slide" pos="0 0 0" axis="0 {} 0" ref="0" )"
      R"(limited="true" range="{} 0" damping="{}" stiffness="0" springref="0" frictionloss="0" )"
      R"(armature="{}" margin="0" solreflimit="0.02 1"/>{}</body>)",
      PartName(fmt::format("finger-{}", side)), PartName(fmt::format("slide-{}", side)), -sign,
      -grasping.width / 2, grasping.force / kSpeed, kArmature,
      ProbeGeom(box, kFingerMass, kRubber));
}

}  // namespace

std::string WithGripper(std::string_view text, const model::GraspingCheck& grasping) {
  const std::string palm = fmt::format(R"(type="box" size="{} {} {}" pos="0 0 {}")", kFinger.x(),
                                       grasping.width / 2 + 2 * kFinger.y(), kPalm,
                                       kTip - 2 * kFinger.z() - kPalm - kClearance);
  const std::string jaws =
      fmt::format(R"(<body name="{}" mocap="true">{}{}{}</body>)", PartName("jaws"),
                  ProbeGeom(palm, kFingerMass, kRubber), Finger(0, grasping), Finger(1, grasping));
  // An equality makes the fingers move together.
  const std::string together = fmt::format(
      R"(<joint joint1="{}" joint2="{}" polycoef="0 1 0 0 0" active="true" solref="0.01 1" )"
      R"(solimp="0.95 0.99 0.001 0.5 2"/>)",
      PartName("slide-0"), PartName("slide-1"));
  return WithBodies(text, jaws, together);
}

Gripper::Gripper(const mjModel& m)
    : m_(m),
      base_(mj_name2id(&m, mjOBJ_BODY, PartName("jaws").c_str())),
      joint_(mj_name2id(&m, mjOBJ_JOINT, PartName("slide-0").c_str())) {
  if (base_ < 0 || joint_ < 0) throw std::runtime_error("the jaws are not in its world");
  width_ = -2 * m.jnt_range[2 * joint_];
}

void Gripper::Place(mjData& d, std::span<const mjtNum> start, const model::Pose& X_WJ,
                    double opening) const {
  mj_resetData(&m_, &d);
  PlaceObject(m_, d, start, joint_, 2);
  const int mocap = m_.body_mocapid[base_];
  compiled::WritePose(X_WJ, d.mocap_pos + 3 * mocap, d.mocap_quat + 4 * mocap);
  // The faces of the fingers meet in the middle if the joints of the fingers are at 0.
  for (int side = 0; side < 2; ++side)
    d.qpos[m_.jnt_qposadr[joint_ + side]] = -std::min(opening, width_) / 2;
}

void Gripper::Press(mjData& d, double force) const {
  for (int side = 0; side < 2; ++side) d.qfrc_applied[m_.jnt_dofadr[joint_ + side]] = force;
}

bool Gripper::Has(int geom) const {
  const int body = m_.geom_bodyid[geom];
  return body >= base_ && body <= base_ + 2;
}

bool Gripper::Touches(const mjData& d) const {
  return std::ranges::any_of(ContactsOf(d), [&](const mjContact& contact) {
    return Has(contact.geom1) != Has(contact.geom2) && contact.dist < 0;
  });
}

bool Gripper::Holds(const mjData& d, int root) const {
  bool holds[2] = {false, false};
  for (const mjContact& contact : ContactsOf(d)) {
    const auto [one, two] = std::minmax(contact.geom1, contact.geom2);
    const int jaw = Has(one) ? one : two;
    const int other = Has(one) ? two : one;
    const int finger = m_.geom_bodyid[jaw] - base_ - 1;
    if (!Has(jaw) || Has(other) || finger < 0) continue;
    if (m_.body_rootid[m_.geom_bodyid[other]] == root) holds[finger] = true;
  }
  return holds[0] && holds[1];
}

}  // namespace mjforge::physics
