// Sets the variables whose values need all bodies of a spec: properties of subtrees, positions of
// sites, and torques of gravity on joints.

#include "mjforge/assemble/whole_properties.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mjforge/assemble/assembly.h"
#include "mjforge/model/model.h"

namespace mjforge::assemble {
namespace {

// MuJoCo's default gravity, m/s^2.
constexpr double kGravity = 9.81;

void ClearEntries(const std::vector<spec::Entry>& entries, std::size_t count,
                  sample::Evaluator& values) {
  for (const spec::Entry& entry : entries) ClearSlots(entry.slot, count, values);
}

// Returns the site with this full name, and the index of its body; null if there is no such site.
std::pair<std::size_t, const model::Site*> FindSite(const model::Object& object,
                                                    std::string_view name) {
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    const auto* found = diag::Find(object.bodies[i].sites, name, &model::Site::name);
    if (found != nullptr) return {i, found};
  }
  return {0, nullptr};
}

// Returns true if a body is not a descendant of `root` yet, because `place:` of the body or of an
// ancestor determines the parent later.
bool IsPlacedLater(const model::Object& object, std::size_t body, std::size_t root) {
  while (body != root && object.bodies[body].parent >= 0)
    body = static_cast<std::size_t>(object.bodies[body].parent);
  return body != root;
}

// Returns the largest torque, Nm, that gravity of any direction exerts on a hinge or ball joint:
// the weight of the subtree times the distance of its centre of mass from the axis, or from the
// centre of the ball joint. The centre of mass is in the frame of the joint's body.
double GravityTorque(const model::MassProperties& subtree, const model::Joint& joint) {
  const Eigen::Vector3d arm = subtree.p_FCm - joint.pos;
  const double distance =
      joint.type == "ball" ? arm.norm() : arm.cross(joint.axis.stableNormalized()).norm();
  return subtree.mass * kGravity * distance;
}

// Returns true if any expression uses a property of one of these joints or sites.
bool AreUsed(const std::vector<spec::Entry>& entries) {
  return std::ranges::any_of(entries, [](const spec::Entry& entry) { return entry.slot >= 0; });
}

// Removes the values of all variables, because `if` may leave out bodies, sites and joints.
void ClearWholeProperties(const Scope& scope) {
  const spec::ObjectSpec& spec = scope.values.spec();
  for (const spec::BodyEntry& body : spec.bodies) {
    ClearSlots(body.first_subtree_property, spec::BodyPropertyNames().size(), scope.values);
    ClearEntries(body.sites, 3, scope.values);
    ClearEntries(body.joints, 1, scope.values);
  }
  ClearEntries(spec.sites, 3, scope.values);
  ClearEntries(spec.joints, 1, scope.values);
}

// Sets NAME.subtree_top and the other properties of subtrees. `bodies` maps full names to
// indices.
void SetSubtrees(const Scope& scope, const model::Object& object,
                 const std::unordered_map<std::string, int>& bodies) {
  for (const spec::BodyEntry& entry : scope.values.spec().bodies) {
    if (entry.first_subtree_property < 0) continue;
    const auto name = spec::LiteralText(entry.head.name);
    std::string full = scope.prefix + std::string(name.value_or(""));
    // The properties of a chain are those of its first link.
    if (entry.head.FindChild(spec::kChainElement) != nullptr) full += "_0";
    const auto found = bodies.find(full);
    if (found == bodies.end()) continue;  // `if` left the body out
    const auto index = static_cast<std::size_t>(found->second);
    SetMeasures(model::SubtreeBounds(object.bodies, index),
                model::SubtreeMass(object.bodies, index).mass, entry.first_subtree_property,
                scope.values);
  }
}

// Sets NAME.pos of sites, in the frame of the spec. `root` is the index of the body to which the
// spec's root elements belong.
void SetPositions(const Scope& scope, const model::Object& object, std::size_t root) {
  const spec::ObjectSpec& spec = scope.values.spec();
  const auto uses_sites = [](const spec::BodyEntry& entry) { return AreUsed(entry.sites); };
  if (!AreUsed(spec.sites) && std::ranges::none_of(spec.bodies, uses_sites)) return;
  const std::vector<model::Pose> X_WB = model::ZeroPoses(object.bodies);
  const model::Pose X_SW = (X_WB[root] * scope.X_BS).Inverse();
  const auto set = [&](const std::vector<spec::Entry>& entries) {
    for (const spec::Entry& entry : entries) {
      const auto name = spec::LiteralText(entry.name);
      if (entry.slot < 0 || !name) continue;
      const auto [body, site] = FindSite(object, scope.prefix + std::string(*name));
      if (site == nullptr || IsPlacedLater(object, body, root)) continue;
      const Eigen::Vector3d p_S = (X_SW * X_WB[body] * site->X_BS).p;
      for (int i = 0; i < 3; ++i) scope.values.SetVariable(entry.slot + i, p_S[i]);
    }
  };
  set(spec.sites);
  for (const spec::BodyEntry& entry : spec.bodies) set(entry.sites);
}

}  // namespace

void ClearSlots(int slot, std::size_t count, sample::Evaluator& values) {
  if (slot < 0) return;
  for (std::size_t i = 0; i < count; ++i)
    values.SetVariable(slot + static_cast<int>(i), sample::kFailedNumber);
}

void SetMeasures(const model::Bounds& bounds, double mass, int slot, sample::Evaluator& values) {
  Eigen::Vector3d half = Eigen::Vector3d::Zero();
  if (!bounds.aabb.empty()) half = bounds.half_size();
  for (const double value : {bounds.top_offset, bounds.bottom_offset, bounds.horizontal_radius,
                             half[0], half[1], half[2], mass})
    values.SetVariable(slot++, value);
}

void Assembly::SetWholeProperties(Scope& scope) {
  const spec::ObjectSpec& spec = scope.values.spec();
  ClearWholeProperties(scope);
  SetSubtrees(scope, object_, bodies_);
  SetPositions(scope, object_, current_body_);
  // Sets torque(NAME), the largest torque of gravity on the joint NAME, for the joints of a body.
  const auto set_torques = [&](const std::vector<spec::Entry>& entries, std::size_t index,
                               sample::StreamId joints) {
    for (const spec::Entry& entry : entries) {
      if (entry.slot < 0) continue;
      repetition_.ForEach(entry, scope.values, joints, [&] {
        const std::string name = scope.values.Text(entry.name, joints).value_or("");
        FieldReader reader(scope.values, findings_, "joint", name,
                           sample::Child(joints, std::string_view(name)));
        model::Joint joint;
        if (!ReadJointGeometry(reader, entry, joint)) return;
        const model::MassProperties subtree = model::SubtreeMass(object_.bodies, index);
        scope.values.SetVariable(entry.slot, GravityTorque(subtree, joint));
      });
    }
  };
  if (AreUsed(spec.joints)) {
    assets_.SumMass(body());
    set_torques(spec.joints, current_body_, sample::Child(scope.values.root(), "joints"));
  }
  const auto uses_torque = [](const Scope::Jointed& jointed) {
    return AreUsed(jointed.entry->joints);
  };
  if (std::ranges::none_of(scope.jointed, uses_torque)) return;
  ForEachJointed(scope, [&](const spec::BodyEntry& entry, std::size_t index) {
    set_torques(entry.joints, index, JointsOf(scope, index));
  });
}

}  // namespace mjforge::assemble
