// The start state of an object: as MuJoCo's zero configuration, as a keyframe, or as both.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "mjforge/mjcf/adapt.h"
#include "mjforge/start/start.h"

namespace mjforge::mjcf {
namespace {

using diag::Code;

// Returns true if the zero configuration of the object is to be its start, unless there are
// obstacles. A keyframe has the poses of free bodies, so that it would ignore the frame to which
// the file is attached; and some hosts read no keyframes.
bool WantsStartAtZero(const model::Object& object, const TargetRules& rules) {
  if (object.start_form) return *object.start_form == model::StartForm::kZero;
  const bool has_free_body = std::ranges::any_of(object.bodies, [](const model::Body& body) {
    return std::ranges::count(body.joints, "free", &model::Joint::type) > 0;
  });
  return has_free_body || !rules.supports_sections;
}

// Errors if the spec asks for a start at zero; otherwise warnings.
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

// Returns true if the zero configuration is the start now.
bool MoveZero(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  if (!WantsStartAtZero(object, rules)) return false;
  std::vector<start::Obstacle> obstacles = start::FindObstacles(object);
  if (obstacles.empty()) {
    start::MoveZeroToStart(object);
    return true;
  }
  ReportObstacles(std::move(obstacles), object.start_form.has_value(), findings);
  return false;
}

}  // namespace

void AdaptStart(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  const bool is_zero = MoveZero(object, rules, findings);
  if (is_zero ? rules.repeats_start : rules.supports_sections) return;
  for (model::Body& body : object.bodies) {
    for (model::Joint& joint : body.joints) {
      if (joint.start.empty()) continue;
      joint.start.clear();
      if (is_zero) continue;
      findings.Warn(Code::kTargetDropped, joint.mark,
                    fmt::format("{} has no keyframes in objects: the pose of joint '{}' is dropped",
                                rules.name, joint.name),
                    "write `start: zero`, or set it where the object is put into a task");
    }
  }
}

}  // namespace mjforge::mjcf
