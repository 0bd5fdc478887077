// Adaptation of an object's start state to a target: the start becomes MuJoCo's zero configuration
// (qpos0), a keyframe, or both.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "mjforge/mjcf/adapt.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/start/start.h"

namespace mjforge::mjcf {
namespace {

using diag::Code;

// Returns true if the start of the object should become its zero configuration (qpos0). The key
// `start:` of the spec decides. Without this key, there are three reasons: a keyframe has poses of
// free bodies in the world frame, which are wrong if the file is attached to another frame; placed
// bodies would overlap at any other zero configuration; some hosts read no keyframes.
bool WantsStartAtZero(const model::Object& object, const TargetRules& rules) {
  if (object.start_form) return *object.start_form == model::StartForm::kZero;
  const auto needs_zero = [](const model::Body& body) {
    return !body.place_name.empty() || model::FreeJointOf(body) != nullptr;
  };
  return std::ranges::any_of(object.bodies, needs_zero) || !rules.supports_sections;
}

// Reports elements that depend on qpos0 and therefore prevent the start from becoming the zero
// configuration: as errors if the spec asks for such a start (`is_asked`), otherwise as warnings.
void ReportObstacles(std::vector<start::Obstacle> obstacles, bool is_asked,
                     diag::Findings& findings) {
  for (start::Obstacle& obstacle : obstacles) {
    const std::string_view outcome =
        is_asked ? "the start cannot be the zero configuration" : "the start is only a keyframe";
    std::string hint = std::move(obstacle.remedy);
    if (!hint.empty()) hint += ", or ";
    hint += "write `start: keyframe`";
    diag::Finding& finding =
        findings.Add(Code::kStartNotZero, obstacle.mark,
                     fmt::format("{}: {}", outcome, obstacle.reason), std::move(hint));
    if (!is_asked) finding.severity = diag::Severity::kWarning;
  }
}

// Warns of velocities and setpoints, because a simulation that begins at the zero configuration
// ignores them: they are only in the keyframe.
void WarnOfMotion(const model::Object& object, diag::Findings& findings) {
  const auto warn = [&](diag::SourceMark mark, std::string message) {
    findings.Warn(Code::kStartNotZero, mark, std::move(message),
                  fmt::format("begin with the keyframe '{}{}', or write `start: keyframe`",
                              object.name, kStartSuffix));
  };
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints) {
      if (!HasStartVelocity(joint)) continue;
      warn(joint.mark ? joint.mark : body.mark,
           fmt::format("joint '{}' has no velocity in the zero configuration", joint.name));
    }
  }
  for (const model::Element& actuator : model::ElementsOf(object, "actuator")) {
    const auto* setpoint = diag::Find(object.setpoints, actuator.name, &model::Setpoint::actuator);
    const bool is_zero =
        setpoint == nullptr || (setpoint->ctrl.value_or(0) == 0 && setpoint->act.value_or(0) == 0);
    if (is_zero) continue;
    warn(setpoint->mark ? setpoint->mark : actuator.mark,
         fmt::format("a reset sets actuator '{}' to 0, not to its setpoint", actuator.name));
  }
}

// Makes the start the zero configuration if this is wanted and possible. Returns true if the start
// is the zero configuration afterwards.
bool MoveZero(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  if (!WantsStartAtZero(object, rules)) return false;
  std::vector<start::Obstacle> obstacles = start::FindObstacles(object);
  if (!obstacles.empty()) {
    ReportObstacles(std::move(obstacles), object.start_form.has_value(), findings);
    return false;
  }
  start::MoveZeroToStart(object);
  if (rules.supports_sections) WarnOfMotion(object, findings);
  return true;
}

// Drops start positions and velocities. Warns of each joint whose position or velocity the file
// loses. Positions are not lost if the start is the zero configuration (`is_zero`).
void DropStart(bool is_zero, model::Object& object, const TargetRules& rules,
               diag::Findings& findings) {
  for (model::Body& body : object.bodies) {
    for (model::Joint& joint : body.joints) {
      const bool loses_pose = !is_zero && !joint.start.empty();
      const bool loses_velocity = HasStartVelocity(joint);
      joint.start.clear();
      joint.start_velocity.clear();
      if (!loses_pose && !loses_velocity) continue;
      findings.Warn(Code::kTargetDropped, joint.mark,
                    fmt::format("{} has no keyframes in objects: the {} of joint '{}' is dropped",
                                rules.name, loses_pose ? "pose" : "velocity", joint.name),
                    loses_pose
                        ? "write `start: zero`, or set it where the object is put into a task"
                        : "set it where the object is put into a task");
    }
  }
}

}  // namespace

void AdaptStart(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  const bool is_zero = MoveZero(object, rules, findings);
  const bool has_motion =
      !object.setpoints.empty() || model::AnyJoint(object, model::HasStartVelocity);
  const bool keeps_keyframe =
      rules.supports_sections && (!is_zero || rules.repeats_start || has_motion);
  if (!keeps_keyframe) DropStart(is_zero, object, rules, findings);
}

}  // namespace mjforge::mjcf
