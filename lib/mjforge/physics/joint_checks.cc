// Finds the joints that entries of checks.joints name, and reports unknown joints and impossible
// positions.
#include "mjforge/physics/joint_checks.h"

#include <algorithm>
#include <span>
#include <string>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/joint_paths.h"
#include "mjforge/physics/named_elements.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {
namespace {

// Returns true if a position is outside of a range by more than a rounding error.
bool IsOutside(const compiled::JointRange& range, double position) {
  const double rounding = 1e-6 * (range.high - range.low);
  return position < range.low - rounding || position > range.high + rounding;
}

// Returns the reason why a joint cannot have a position; nullopt if the position is valid.
std::optional<std::string> PositionProblem(const mjModel& m, int joint, const std::string& name,
                                           std::span<const double> position) {
  const std::size_t size = kPositionSizes[m.jnt_type[joint]];
  if (position.size() != size) {
    return fmt::format("the position of joint '{}' takes {}, not {}", name,
                       diag::Counted(size, "number"), position.size());
  }
  const std::optional<compiled::JointRange> range = compiled::RangeOf(m, joint);
  const bool is_limited = compiled::HasOneNumber(m, joint) && range && range->limited;
  if (!is_limited || !IsOutside(*range, position.front())) return std::nullopt;
  const bool is_slide = m.jnt_type[joint] == mjJNT_SLIDE;
  return fmt::format("joint '{}' cannot stand at {}: its range is {} to {}", name,
                     expr::DistanceText(is_slide, position.front()),
                     expr::DistanceText(is_slide, range->low),
                     expr::DistanceText(is_slide, range->high));
}

}  // namespace

bool JointChecks::Verify(static_checks::Reporter& reporter) const {
  bool is_right = true;
  const auto wrong = [&](diag::Code code, const model::JointCheck& check, const std::string& what,
                         std::string hint = {}) {
    is_right = false;
    reporter.Error(code, check.mark, "checks.joints: " + what, std::move(hint));
  };
  const auto exists = [&](const model::JointCheck& check, const std::string& name) {
    if (Find(name)) return true;
    const std::vector<std::string> names = OwnNames(m_, mjOBJ_JOINT, object_);
    wrong(diag::Code::kModelUnknownReference, check,
          fmt::format("the object has no joint '{}'", name), diag::DidYouMean(name, names));
    return false;
  };
  for (const model::JointCheck& check : checks_.joints) {
    for (const std::string& name : check.joints) {
      if (!exists(check, name) || !check.rests || compiled::HasOneNumber(m_, *Find(name))) continue;
      wrong(diag::Code::kModelBadValue, check,
            fmt::format("`rests` is for hinges and slides, which '{}' is not", name));
    }
    for (const auto& [name, position] : check.positions) {
      if (!exists(check, name)) continue;
      const auto problem = PositionProblem(m_, *Find(name), name, position);
      if (problem) wrong(diag::Code::kModelBadValue, check, *problem);
    }
  }
  return is_right;
}

std::vector<int> JointChecks::Others() const {
  std::vector<int> joints;
  for (int joint = 0; joint < m_.njnt; ++joint) {
    const auto names = [&](const model::JointCheck& check) { return Names(check, joint); };
    if (CanBeDriven(joint) && std::ranges::none_of(checks_.joints, names)) joints.push_back(joint);
  }
  return joints;
}

std::vector<int> JointChecks::JointsOf(const model::JointCheck& check) const {
  std::vector<int> joints;
  for (const std::string& name : check.joints) {
    if (CanBeDriven(*Find(name))) joints.push_back(*Find(name));
  }
  return joints;
}

std::vector<mjtNum> JointChecks::StartOf(const model::JointCheck& check) const {
  const std::span<const mjtNum> usual = compiled::StartOf(m_);
  std::vector<mjtNum> start(usual.begin(), usual.end());
  for (const auto& [name, numbers] : check.positions)
    std::ranges::copy(numbers, start.begin() + m_.jnt_qposadr[*Find(name)]);
  return start;
}

bool JointChecks::CanBeDriven(int joint) const {
  return !PathsOf(m_, joint, compiled::StartOf(m_)).empty();
}

std::optional<int> JointChecks::Find(const std::string& joint) const {
  return IdOf(m_, mjOBJ_JOINT, object_, joint);
}

bool JointChecks::Names(const model::JointCheck& check, int joint) const {
  return std::ranges::any_of(check.joints,
                             [&](const std::string& name) { return Find(name) == joint; });
}

}  // namespace mjforge::physics
