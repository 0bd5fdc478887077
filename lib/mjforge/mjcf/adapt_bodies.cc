#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "mjforge/mjcf/adapt.h"

namespace mjforge::mjcf {
namespace {

using diag::Code;

model::Attribute Numbers(std::string_view name, std::initializer_list<double> numbers) {
  return {name, model::Applies::kBoth, {numbers.begin(), numbers.end()}, {}};
}

// As robosuite's own objects have them: there, but not to be seen.
model::Site BoundsSite(std::string name, const Eigen::Vector3d& pos, diag::SourceMark mark) {
  model::Site site;
  site.name = std::move(name);
  site.X_BS.p = pos;
  site.attributes.push_back(Numbers("rgba", {0, 0, 0, 0}));
  site.mark = mark;
  return site;
}

void PutIntoOuterBody(model::Object& object) {
  model::Body outer;
  outer.mark = object.bodies.front().mark;
  const model::Bounds& bounds = object.bounds;
  const double radius = bounds.horizontal_radius;
  outer.sites.push_back(BoundsSite("bottom_site", {0.0, 0.0, bounds.bottom_offset}, outer.mark));
  outer.sites.push_back(BoundsSite("top_site", {0.0, 0.0, bounds.top_offset}, outer.mark));
  // x is the radius; robosuite's half size of the object takes y from it, too.
  outer.sites.push_back(BoundsSite("horizontal_radius_site", {radius, radius, 0.0}, outer.mark));
  for (model::Body& body : object.bodies) ++body.parent;
  object.bodies.insert(object.bodies.begin(), std::move(outer));
}

void AddRegionBox(model::Object& object) {
  const model::Box3& box = object.bounds.aabb;
  model::Body& root = object.bodies.front();
  model::Part part;
  part.name = "reg_bbox";
  part.role = model::Role::kVisual;
  part.as_is = true;
  part.shape = {model::GeomType::kBox, object.bounds.half_size(), nullptr};
  part.X_BG.p = (box.min + box.max) / 2;
  part.attributes = {Numbers("contype", {0}), Numbers("conaffinity", {0}), Numbers("group", {1}),
                     Numbers("rgba", {0, 1, 0, 0})};
  part.mark = root.mark;
  root.parts.push_back(std::move(part));
}

// The host adds one of its own, which has nothing but its type.
void DropFreeJoint(model::Body& root, const TargetRules& rules, diag::Findings& findings) {
  const auto free = std::ranges::find(root.joints, "free", &model::Joint::type);
  if (free == root.joints.end()) return;
  if (!free->attributes.empty()) {
    std::vector<std::string_view> lost;
    for (const model::Attribute& attribute : free->attributes) lost.push_back(attribute.name);
    findings.Warn(
        Code::kTargetDropped, free->mark,
        fmt::format("{} adds the free joint itself: the attributes of joint '{}' are dropped ({})",
                    rules.name, free->name, Listed(lost)),
        "set them where the object is loaded (joints=...)");
  }
  root.joints.erase(free);
}

// The host renames the root body, but not what looks at it.
void DropLooksAtRoot(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  const auto looks_at_root = [&](const model::Element& element) {
    return std::ranges::any_of(element.attributes, [&](const model::Attribute& attribute) {
      return attribute.refers == "body" && attribute.text == rules.root;
    });
  };
  for (model::Body& body : object.bodies) {
    for (const model::Element& element : body.elements) {
      if (!looks_at_root(element)) continue;
      findings.Warn(Code::kTargetDropped, element.mark,
                    fmt::format("{} renames the root body: {} '{}', which looks at it, is dropped",
                                rules.name, element.tag, element.name));
    }
    std::erase_if(body.elements, looks_at_root);
  }
}

// The host takes one body, with all that is on it.
bool HasOneRoot(const model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  const auto is_other_root = [&](const model::Body& body) {
    return body.parent < 0 && &body != &object.bodies.front();
  };
  const auto found = std::ranges::find_if(object.bodies, is_other_root);
  if (found == object.bodies.end()) return true;
  findings.Add(
      Code::kTargetOneRoot, found->mark,
      fmt::format("{} takes objects of one root, but body '{}' is free", rules.name, found->name),
      "make it an object of its own, or use --target mujoco, scene or mjx");
  return false;
}

void DropPositions(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  for (model::Body& body : object.bodies) {
    for (model::Joint& joint : body.joints) {
      if (joint.start.empty()) continue;
      findings.Warn(Code::kTargetDropped, joint.mark,
                    fmt::format("{} has no keyframes in objects: the pose of joint '{}' is dropped",
                                rules.name, joint.name),
                    "set it where the object is put into a task");
      joint.start.clear();
    }
  }
}

}  // namespace

void AdaptBodies(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  if (!rules.sections) DropPositions(object, rules, findings);
  if (!rules.root.empty() && !HasOneRoot(object, rules, findings)) return;
  if (!rules.free_joint) DropFreeJoint(object.bodies.front(), rules, findings);
  if (!rules.root.empty()) DropLooksAtRoot(object, rules, findings);
  if (rules.region_box) AddRegionBox(object);
  if (rules.outer_body) PutIntoOuterBody(object);
}

}  // namespace mjforge::mjcf
