// Adaptation of an object to its target, the program that loads the file: the order of the steps.

#include "mjforge/mjcf/adapt.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "mjforge/mjcf/mjcf.h"

namespace mjforge::mjcf {

std::string JoinNames(std::span<const std::string_view> names) {
  constexpr std::size_t kShown = 5;
  const std::size_t shown = std::min(names.size(), kShown);
  std::string text = fmt::format("{}", fmt::join(names.first(shown), ", "));
  if (shown < names.size()) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

void Adapt(model::Object& object, Target target, diag::Findings& findings) {
  const TargetRules& rules = RulesOf(target);
  if (object.bodies.empty()) return;
  // Drops sections first, so that elements that are dropped anyway do not prevent AdaptStart() from
  // making the start state the zero configuration (qpos0).
  AdaptSections(object, rules, findings);
  AdaptStart(object, rules, findings);
  if (!rules.adapts()) return;
  AdaptShapes(object, rules, findings);
  AdaptGeoms(object, rules, findings);
  CheckNames(object, rules, findings);
  AdaptBodies(object, rules, findings);
}

}  // namespace mjforge::mjcf
