#include "mjforge/physics/behaviour.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace mjforge::physics {
namespace {

using diag::Code;

constexpr const char* kHarderContacts = "use harder contacts: a smaller solref, solimp closer to 1";

constexpr double kDegrees = 180 / std::numbers::pi;

/// A joint's distance for people: degrees of hinges and balls, millimetres of slides.
std::string Distance(const mjModel& m, int joint, double value) {
  if (m.jnt_type[joint] == mjJNT_SLIDE) return fmt::format("{:.3g} mm", 1000 * value);
  return fmt::format("{:.3g} deg", kDegrees * value);
}

}  // namespace

diag::SourceMark Behaviour::MarkOf(std::string_view joint) const {
  for (const model::Body& body : object_.bodies) {
    const auto found = std::ranges::find(body.joints, joint, &model::Joint::name);
    if (found != body.joints.end() && found->mark) return found->mark;
  }
  return mark_;
}

Trouble Behaviour::Drop(Result& result) {
  for (;;) {
    mjData& d = workspace_.For(m_);
    Trouble trouble = Settle(m_, d, verdict_.checks(), result);
    // Without room for its contacts it would have fallen through the floor.
    if (!IsCrowded(d) || !MakeRoom(m_)) return trouble;
    result = {};
  }
}

// MuJoCo steps any model; what comes of steps that are longer than a fall says nothing.
bool Behaviour::CanStep() {
  constexpr double kShortest = 1e-5;  // s
  constexpr double kLongest = 0.02;   // s; from 2 mm above the floor things fall for 0.02 s
  constexpr double kMostSteps = 1e7;
  const double timestep = m_.opt.timestep;
  const double steps = verdict_.checks().settle_time / timestep;
  if (timestep >= kShortest && timestep <= kLongest && steps <= kMostSteps) return true;
  verdict_.Error(
      Code::kPhysicsUnstable, mark_,
      fmt::format("'{}' cannot be simulated: {:g} s in steps of {:g} s", object_.name,
                  verdict_.checks().settle_time, timestep),
      fmt::format("use a timestep of {:g} to {:g} s and a settle_time of at most {:g} steps",
                  kShortest, kLongest, kMostSteps));
  return false;
}

void Behaviour::Check(Result& result) {
  if (!CanStep()) return;
  const Trouble trouble = Drop(result);
  ReportDrop(trouble, result);
  if (trouble.blown_up) return;
  for (const Driven& driven : DriveJoints(m_, workspace_.For(m_))) {
    result.joints.push_back(driven.measured);
    ReportJoint(driven);
  }
}

void Behaviour::ReportDrop(const Trouble& trouble, const Result& result) {
  for (const std::string& warning : trouble.warnings) {
    verdict_.Error(Code::kPhysicsUnstable, mark_,
                   fmt::format("MuJoCo warns as '{}' settles: {}", object_.name, warning),
                   trouble.blown_up ? "use a smaller timestep, softer contacts, or larger masses "
                                      "and inertias for its forces"
                                    : "");
  }
  if (trouble.blown_up) return;
  const model::Checks& checks = verdict_.checks();
  if (result.energy_gain > checks.energy_gain) {
    verdict_.Error(Code::kPhysicsGainsEnergy, mark_,
                   fmt::format("'{}' gains energy as it settles: {} of mass * gravity * size, "
                               "more than {:g}",
                               object_.name, NumberBeyond(result.energy_gain, checks.energy_gain),
                               checks.energy_gain),
                   "look for parts that push each other apart, springs, or actuators");
  }
  if (!result.at_rest && result.dropped && result.ncon == 0) {
    verdict_.Warning(Code::kPhysicsNotAtRest, mark_,
                     fmt::format("'{}' touches nothing for {:g} s and ends at {:.3g} m/s",
                                 object_.name, result.time, result.speed),
                     "check gravity and the contact bits (contype, conaffinity)");
  } else if (!result.at_rest && result.dropped) {
    verdict_.Warning(
        Code::kPhysicsNotAtRest, mark_,
        fmt::format("'{}' still moves after {:g} s: body '{}' at {:.3g} m/s, {:.3g} mm "
                    "from where it began",
                    object_.name, result.time, trouble.fastest, result.speed, 1000 * trouble.way),
        "look for an undamped joint or a part that rolls, or set a longer `settle_time`");
  }
  if (result.penetration > checks.penetration) {
    verdict_.Error(Code::kPhysicsPenetrates, mark_,
                   fmt::format("contacts get {} mm deep as '{}' lands, more than {:g} mm",
                               NumberBeyond(1000 * result.penetration, 1000 * checks.penetration),
                               object_.name, 1000 * checks.penetration),
                   kHarderContacts);
  }
  if (result.sink > checks.sink) {
    verdict_.Error(Code::kPhysicsSinks, mark_,
                   fmt::format("contacts are {} mm deep when '{}' has settled, more than {:g} mm",
                               NumberBeyond(1000 * result.sink, 1000 * checks.sink), object_.name,
                               1000 * checks.sink),
                   kHarderContacts);
  }
  ReportPose(result);
}

void Behaviour::ReportPose(const Result& result) {
  const model::Checks& checks = verdict_.checks();
  if (checks.stable && result.tilt > checks.tilt) {
    verdict_.Error(
        Code::kPhysicsTopples, mark_,
        fmt::format("'{}' topples: it leans over by {} deg, more than {:.3g} deg", object_.name,
                    NumberBeyond(kDegrees * result.tilt, kDegrees * checks.tilt),
                    kDegrees * checks.tilt),
        "give it a wider foot or a lower centre of mass");
  }
  if (result.drift > checks.drift) {
    verdict_.Error(
        Code::kPhysicsDrifts, mark_,
        fmt::format("'{}' moves {} mm along the floor, more than {:g} mm", object_.name,
                    NumberBeyond(1000 * result.drift, 1000 * checks.drift), 1000 * checks.drift),
        "give it a level foot or more friction");
  }
}

void Behaviour::ReportJoint(const Driven& driven) {
  const model::Checks& checks = verdict_.checks();
  const Result::Joint& joint = driven.measured;
  const diag::SourceMark mark = MarkOf(joint.name);
  if (driven.blown_up) {
    verdict_.Error(Code::kPhysicsUnstable, mark,
                   fmt::format("the simulation diverges as joint '{}' is driven", joint.name));
    return;
  }
  if (driven.outside > checks.joint_overshoot * driven.range) {
    verdict_.Error(Code::kPhysicsJointOvershoots, mark,
                   fmt::format("joint '{}' begins {} outside its range of {}", joint.name,
                               Distance(m_, driven.joint, driven.outside),
                               Distance(m_, driven.joint, driven.range)),
                   "use a range that contains zero, or a pose (`ref`) within the range");
  } else if (joint.overshoot > checks.joint_overshoot * driven.range) {
    verdict_.Error(Code::kPhysicsJointOvershoots, mark,
                   fmt::format("joint '{}' goes {} beyond its range of {}", joint.name,
                               Distance(m_, driven.joint, joint.overshoot),
                               Distance(m_, driven.joint, driven.range)),
                   "use a harder limit: a smaller solreflimit, solimplimit closer to 1");
  }
  if (joint.penetration > checks.joint_penetration) {
    verdict_.Error(
        Code::kPhysicsJointCollides, mark,
        fmt::format(
            "driving joint '{}' pushes bodies '{}' and '{}' {:.3g} mm into each other, at {}",
            joint.name, driven.body1, driven.body2, 1000 * joint.penetration,
            Distance(m_, driven.joint, driven.where)),
        "use a shorter range, make room, or add `contact: exclude`");
  }
  if (joint.reach < checks.joint_reach) {
    verdict_.Error(Code::kPhysicsJointBlocked, mark,
                   fmt::format("joint '{}' reaches only {:.3g} % of its range of {}{}", joint.name,
                               100 * joint.reach, Distance(m_, driven.joint, driven.range),
                               driven.body1.empty() ? std::string()
                                                    : fmt::format(": '{}' and '{}' collide",
                                                                  driven.body1, driven.body2)),
                   driven.body1.empty()
                       ? "it is held back by something that an equality or a tendon couples it to"
                       : "use a shorter range, make room, or add `contact: exclude`");
  }
  if (joint.return_error > checks.joint_return * driven.range) {
    verdict_.Error(Code::kPhysicsJointNotBack, mark,
                   fmt::format("joint '{}' does not come back: it ends {} from where it started",
                               joint.name, Distance(m_, driven.joint, joint.return_error)));
  }
}

}  // namespace mjforge::physics
