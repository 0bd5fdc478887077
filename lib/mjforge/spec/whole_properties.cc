// Properties that expressions can read when all bodies are there: of subtrees, joints and sites.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/spec/context.h"

namespace mjforge::spec {
namespace {

using diag::Code;

// The dimension of a torque, N m.
constexpr expr::Dimension kTorque{2, 1, -2};

// Keys of a joint from which its torque is computed.
constexpr std::string_view kGeometry[] = {"type", "pos", "axis"};

// Joints with these types have a torque.
constexpr std::string_view kTurning[] = {"hinge", "ball"};

void DeclareTorque(const YamlNode& joint, expr::SymbolTable& names) {
  const YamlNode* name = joint.Find("name");
  const YamlNode* type = joint.Find("type");
  if (name == nullptr || !expr::IsName(name->text)) return;
  if (type != nullptr && std::ranges::find(kTurning, type->text) == std::end(kTurning)) return;
  const std::string torque = expr::TorqueVariable(name->text);
  if (names.Find(torque) == nullptr) names.Declare(torque, expr::Type::kNumber, 1, {kTorque});
}

void DeclarePositions(std::vector<Entry>& sites, expr::SymbolTable& names) {
  for (Entry& site : sites) {
    const auto name = LiteralText(site.name);
    if (!name || !expr::IsName(*name)) continue;
    const std::string position = expr::PositionVariable(*name);
    const auto* known = names.Find(position);
    const auto* variable =
        known != nullptr ? known
                         : &names.Declare(position, expr::Type::kNumber, 3, *DimensionsOf("m"));
    site.slot = variable->slot;
  }
}

}  // namespace

void DeclareWholeProperties(std::span<const YamlNode* const> joint_lists, Context& context) {
  expr::SymbolTable& names = context.spec.names;
  for (BodyEntry& body : context.spec.bodies) {
    const auto name = LiteralText(body.head.name);
    if (!name || !expr::IsName(*name)) continue;
    const std::string prefix = fmt::format("{}.{}", *name, kSubtreePrefix);
    const auto* known = names.Find(prefix + std::string(BodyPropertyNames().front()));
    body.first_subtree_property = known ? known->slot : DeclareMeasures(prefix, names);
  }
  for (BodyEntry& body : context.spec.bodies) {
    // The pose of a placed body is not known yet.
    if (!body.place) DeclarePositions(body.sites, names);
  }
  DeclarePositions(context.spec.sites, names);
  for (const YamlNode* list : joint_lists) {
    for (const YamlNode& joint : list->items) DeclareTorque(joint, names);
  }
}

void ReadTorqueUse(const YamlNode& joint, Entry& entry, Context& context) {
  const auto name = LiteralText(entry.name);
  if (!name) return;
  const auto* torque = context.spec.names.Find(expr::TorqueVariable(*name));
  if (torque == nullptr) return;
  entry.slot = torque->slot;
  for (const std::string_view key : kGeometry) {
    const YamlNode* value = joint.Find(key);
    if (value == nullptr) continue;
    std::vector<std::string> used;
    CollectNames(*value, used);
    const bool calls = std::ranges::find(used, "torque") != used.end() &&
                       context.spec.names.Find("torque") == nullptr;
    if (!calls) continue;
    context.findings.Add(Code::kSpecConflict, value->mark,
                         fmt::format("the '{}' of a joint with torque() is a circle: the torque is "
                                     "computed from it",
                                     key));
  }
}

}  // namespace mjforge::spec
