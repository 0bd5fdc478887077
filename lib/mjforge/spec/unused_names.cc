// Warnings about parameters, functions, local values and materials that are never used, and removal
// of the slots of unused properties of bodies, joints and sites.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/spec/context.h"

namespace mjforge::spec {

namespace {

// Sets the slot of an entry to -1 if the name of the entry is a literal for which is_used() returns
// false.
template <typename IsUsed>
void DropSlots(std::vector<Entry>& entries, const IsUsed& is_used) {
  for (Entry& entry : entries) {
    const auto name = LiteralText(entry.name);
    if (name && !is_used(*name)) entry.slot = -1;
  }
}

}  // namespace

void DropUnusedProperties(Context& context) {
  const UsedNames& uses = context.values.uses();
  const auto is_joint_used = [&](std::string_view joint) {
    return uses.names.contains(expr::TorqueVariable(joint));
  };
  const auto is_site_used = [&](std::string_view site) {
    return uses.HasMember(expr::PositionVariable(site) + ".");
  };
  for (BodyEntry& body : context.spec.bodies) {
    DropSlots(body.joints, is_joint_used);
    DropSlots(body.sites, is_site_used);
    const auto name = LiteralText(body.head.name);
    if (!name) continue;
    if (!uses.names.contains(*name)) body.first_property = -1;
    if (!uses.HasMember(fmt::format("{}.{}", *name, kSubtreePrefix)))
      body.first_subtree_property = -1;
  }
  DropSlots(context.spec.joints, is_joint_used);
  DropSlots(context.spec.sites, is_site_used);
}

void ReportUnused(const YamlNode* materials, Context& context) {
  // Skips the check after an error: parts of the spec were not read, so names that they use would
  // be reported as unused.
  if (context.findings.HasErrors()) return;
  const auto& silenced = context.spec.checks.silenced;
  if (std::ranges::find(silenced, diag::Code::kSpecUnused, &Checks::Silence::code) !=
      silenced.end()) {
    return;
  }
  const UsedNames& uses = context.values.uses();
  const auto report = [&](std::string_view what, std::string_view name, diag::SourceMark mark) {
    context.findings.Warn(
        diag::Code::kSpecUnused, mark, fmt::format("{} '{}' is never used", what, name),
        "remove it, or say why it is there: `checks: {silence: {spec/unused: ...}}`");
  };
  for (const Parameter& parameter : context.spec.parameters) {
    // A record is used if any of its columns is used.
    const std::string name = parameter.name.substr(0, parameter.name.find('.'));
    const bool is_column = name != parameter.name && parameter.record.empty();
    const bool is_shared = std::holds_alternative<SharedParameter>(parameter.value.form);
    if (!is_column && !is_shared && !uses.names.contains(name))
      report("parameter", name, parameter.mark);
  }
  for (const auto& [name, mark] : context.spec.functions) {
    if (!uses.names.contains(name)) report("function", name, mark);
  }
  for (const auto& [name, mark] : context.locals) {
    if (!uses.names.contains(name)) report("local value", name, mark);
  }
  if (materials == nullptr || uses.any_material) return;
  for (const YamlNode::Pair& pair : materials->pairs) {
    if (!uses.materials.contains(pair.key)) report("material", pair.key, pair.mark);
  }
}

}  // namespace mjforge::spec
