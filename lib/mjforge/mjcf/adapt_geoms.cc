// Adaptation of parts to a target: geom groups, densities, margins, and separate parts for
// collision and visual geoms.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "mjforge/mjcf/adapt.h"

namespace mjforge::mjcf {
namespace {

using diag::Code;
using model::Applies;
using model::Part;
using model::Role;

// Names of parts with an attribute that the target overrides or drops, for a warning.
struct AffectedParts {
  std::vector<std::string_view> names;
  diag::SourceMark first;
  void Add(const Part& part) {
    if (names.empty()) first = part.mark;
    if (names.empty() || names.back() != part.name) names.push_back(part.name);
  }
};

// Returns true if the attribute `group` of the part's spec differs from the group that the target
// requires for any geom of this part.
bool Contradicts(const Part& part, const model::Attribute& group, const TargetRules& rules) {
  const double number = group.numbers.empty() ? -1 : group.numbers[0];
  const bool on_collision = part.role != Role::kVisual && group.applies != Applies::kVisual;
  const bool on_visual = part.role != Role::kCollision && group.applies != Applies::kCollision;
  return (on_collision && number != rules.collision_group) ||
         (on_visual && number != rules.visual_group);
}

void SetGroup(Part& part, const TargetRules& rules, AffectedParts& affected) {
  const auto group = std::ranges::find(part.attributes, "group", &model::Attribute::name);
  if (group != part.attributes.end()) {
    // Does not warn about parts of attached files, because the groups in these files were not
    // chosen for this target.
    if (!part.as_is && Contradicts(part, *group, rules)) affected.Add(part);
    part.attributes.erase(group);
  }
  if (!part.as_is) return;  // WriteMjcf adds the group
  const int number = part.role == Role::kVisual ? rules.visual_group : rules.collision_group;
  part.attributes.push_back({.name = "group", .numbers = {static_cast<double>(number)}});
}

void DropMargins(Part& part, AffectedParts& affected) {
  const auto is_margin = [](const model::Attribute& attribute) {
    return attribute.name == "margin" || attribute.name == "gap";
  };
  for (const model::Attribute& attribute : part.attributes) {
    const bool is_nonzero = !attribute.numbers.empty() && attribute.numbers[0] != 0;
    if (is_margin(attribute) && is_nonzero) affected.Add(part);
  }
  std::erase_if(part.attributes, is_margin);
}

// Splits each part that both collides and is visible into a collision part and a visual part. The
// collision part keeps its material and color, because the host also shows a copy of each collision
// geom.
void SplitRoles(std::vector<Part>& parts) {
  std::vector<Part> split;
  split.reserve(2 * parts.size());
  for (Part& part : parts) {
    const bool has_both = part.role == Role::kBoth && !part.as_is;
    Part& first = split.emplace_back(std::move(part));
    if (!has_both) continue;
    first.role = Role::kCollision;
    Part second = first;
    second.role = Role::kVisual;
    second.mass = second.density = 0.0;
    if (first.material < 0 && model::FindAttribute(first.attributes, "rgba") == nullptr) {
      first.attributes.push_back(
          {.name = "rgba", .numbers = {0.5, 0.5, 0.5, 1}});  // MuJoCo's default color
    }
    split.push_back(std::move(second));
  }
  parts = std::move(split);
}

}  // namespace

void AdaptGeoms(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  AffectedParts groups;
  AffectedParts margins;
  for (model::Body& body : object.bodies) {
    for (Part& part : body.parts) {
      if (!rules.keeps_groups) SetGroup(part, rules, groups);
      if (!rules.supports_margins && part.role != Role::kVisual) DropMargins(part, margins);
      if (rules.writes_mass) part.density = 0.0;
    }
  }
  if (!groups.names.empty()) {
    findings.Warn(
        Code::kTargetDropped, groups.first,
        fmt::format("{} tells collision geoms ({}) from visual ones ({}) by their group: 'group' "
                    "of {} is overridden",
                    rules.name, rules.collision_group, rules.visual_group, JoinNames(groups.names)),
        "set 'role' to 'collision' or 'visual' instead");
  }
  if (!margins.names.empty()) {
    findings.Warn(
        Code::kTargetDropped, margins.first,
        fmt::format(
            "{} does not support margins when meshes collide: 'margin' and 'gap' of {} are dropped",
            rules.name, JoinNames(margins.names)));
  }
  if (!rules.shows_collision_copies) return;
  for (model::Body& body : object.bodies) SplitRoles(body.parts);
}

}  // namespace mjforge::mjcf
