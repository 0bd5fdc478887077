// Properties of subtrees, joints and sites, which expressions can use after all bodies are read.

#include <algorithm>
#include <map>
#include <string>

#include <fmt/format.h>

#include "mjforge/spec/context.h"

namespace mjforge::spec {
namespace {

using diag::Code;

// The dimension of a torque, N m.
constexpr expr::Dimension kTorque{2, 1, -2};

// Keys of a joint that cannot use torque(), because these keys determine the torque.
constexpr std::string_view kGeometry[] = {"type", "pos", "axis", "for", "if", "let"};

// Types of joints whose torque(NAME) expressions can use.
constexpr std::string_view kTurning[] = {"hinge", "ball"};

void DeclareTorque(const YamlNode& joint, Context& context) {
  const YamlNode* name = joint.Find("name");
  const YamlNode* type = joint.Find("type");
  if (name == nullptr || !expr::IsName(name->text) || joint.Find("screw") != nullptr) return;
  const Field* fallback = FindField(context.spec.defaults.joint, Key::kType);
  const std::string_view word =
      type != nullptr ? std::string_view(type->text) : JointType(fallback);
  if (std::ranges::find(kTurning, word) == std::end(kTurning)) return;
  expr::SymbolTable& names = context.spec.names;
  const std::string torque = expr::TorqueVariable(name->text);
  if (names.Find(torque) == nullptr) names.Declare(torque, expr::Type::kNumber, 1, {kTorque});
}

// Slots (indices of variables) of the declared properties. The keys are NAME.pos for each site, and
// NAME.subtree_ for each body; the slot for NAME.subtree_ is that of the first property. Entries of
// the same name, which have different conditions, share the slots. A property is not declared if a
// parameter of a nested spec has the same name.
using Declared = std::map<std::string, int>;

void DeclarePositions(std::vector<Entry>& sites, expr::SymbolTable& names, Declared& declared) {
  for (Entry& site : sites) {
    const auto name = LiteralText(site.name);
    if (!name || !expr::IsName(*name)) continue;
    const std::string position = expr::PositionVariable(*name);
    if (!declared.contains(position) && names.Find(position) == nullptr) {
      const auto& variable = names.Declare(position, expr::Type::kNumber, 3, *DimensionsOf("m"));
      declared.emplace(position, variable.slot);
    }
    if (declared.contains(position)) site.slot = declared.at(position);
  }
}

void DeclareSubtree(BodyEntry& body, expr::SymbolTable& names, Declared& declared) {
  const auto name = LiteralText(body.head.name);
  if (!name || !expr::IsName(*name)) return;
  const std::string prefix = fmt::format("{}.{}", *name, kSubtreePrefix);
  const auto is_taken = [&](std::string_view property) {
    return names.Find(prefix + std::string(property)) != nullptr;
  };
  if (!declared.contains(prefix) && std::ranges::none_of(BodyPropertyNames(), is_taken))
    declared.emplace(prefix, DeclareBodyProperties(prefix, names));
  if (declared.contains(prefix)) body.first_subtree_property = declared.at(prefix);
}

}  // namespace

void DeclareWholeProperties(std::span<const YamlNode* const> joint_lists, Context& context) {
  expr::SymbolTable& names = context.spec.names;
  Declared declared;
  for (BodyEntry& body : context.spec.bodies) {
    DeclareSubtree(body, names, declared);
    // Skips the sites of a body with `place:`, because the pose of the body is not known yet.
    if (!body.place) DeclarePositions(body.sites, names, declared);
  }
  DeclarePositions(context.spec.sites, names, declared);
  for (const YamlNode* list : joint_lists) {
    for (const YamlNode& joint : list->items) DeclareTorque(joint, context);
  }
}

void ReadTorqueUse(const YamlNode& joint, Entry& entry, Context& context) {
  const auto name = LiteralText(entry.name);
  const auto* torque = context.spec.names.Find(expr::TorqueVariable(name.value_or("")));
  if (torque != nullptr) entry.slot = torque->slot;
  if (context.spec.names.Find("torque") != nullptr) return;  // a parameter is named `torque`
  for (const std::string_view key : kGeometry) {
    const YamlNode* value = joint.Find(key);
    if (value == nullptr) continue;
    std::vector<std::string> used;
    CollectNames(*value, used);
    if (std::ranges::find(used, "torque") == used.end()) continue;
    context.findings.Add(
        Code::kSpecConflict, value->mark,
        fmt::format("'{}' of a joint cannot use torque(), which is computed from it", key));
  }
}

}  // namespace mjforge::spec
