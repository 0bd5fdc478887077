// Adaptation of bodies to a target: adds an outer body, sites at the bounds and geoms for regions;
// drops the free joint that the host adds itself.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "mjforge/mjcf/adapt.h"

namespace mjforge::mjcf {
namespace {

using diag::Code;

// Makes an invisible site at a bound of the object, like the sites of robosuite's own objects.
model::Site MakeBoundsSite(std::string name, const Eigen::Vector3d& pos, diag::SourceMark mark) {
  model::Site site;
  site.name = std::move(name);
  site.X_BS.p = pos;
  site.attributes.push_back({.name = "rgba", .numbers = {0, 0, 0, 0}});
  site.mark = mark;
  return site;
}

void PutIntoOuterBody(model::Object& object) {
  model::Body outer;
  outer.mark = object.bodies.front().mark;
  const model::Bounds& bounds = object.bounds;
  const double radius = bounds.horizontal_radius;
  outer.sites.push_back(
      MakeBoundsSite("bottom_site", {0.0, 0.0, bounds.bottom_offset}, outer.mark));
  outer.sites.push_back(MakeBoundsSite("top_site", {0.0, 0.0, bounds.top_offset}, outer.mark));
  // robosuite reads the radius from x, and half sizes of the object from x and y.
  outer.sites.push_back(
      MakeBoundsSite("horizontal_radius_site", {radius, radius, 0.0}, outer.mark));
  for (model::Body& body : object.bodies) ++body.parent;
  object.bodies.insert(object.bodies.begin(), std::move(outer));
}

// Adds a visual geom `reg_NAME`, which robocasa reads as the region NAME.
void AddRegionGeom(std::string_view name, const model::Shape& shape, const model::Pose& X_BG,
                   diag::SourceMark mark, model::Body& body) {
  model::Part part;
  part.name = fmt::format("reg_{}", name);
  part.role = model::Role::kVisual;
  part.as_is = true;
  part.shape = shape;
  part.X_BG = X_BG;
  part.attributes = {{.name = "contype", .numbers = {0}},
                     {.name = "conaffinity", .numbers = {0}},
                     {.name = "group", .numbers = {1}},
                     {.name = "rgba", .numbers = {0, 1, 0, 0}}};
  part.mark = mark;
  body.parts.push_back(std::move(part));
}

// Adds a geom for the object's bounding box, and one for the space above each region, from which
// robocasa reads the region: its area, extruded by its height. Polygons become boxes. robocasa
// calls the region `inside` `int`.
void AddRegionGeoms(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  constexpr double kOpenHeight = 0.5;  // m, for regions without an upper limit
  const model::Box3& box = object.bounds.aabb;
  model::Body& root = object.bodies.front();
  AddRegionGeom("bbox", {model::GeomType::kBox, object.bounds.half_size(), nullptr},
                {.p = (box.min + box.max) / 2}, root.mark, root);
  std::set<std::string, std::less<>> names = {"bbox"};  // names of robocasa's regions so far
  for (model::Body& body : object.bodies) {
    for (const model::Region& region : body.regions) {
      const std::string name = region.site == "inside" ? "int" : region.site;
      if (!names.insert(name).second) {
        findings.Add(Code::kModelDuplicateName, region.mark,
                     fmt::format("region '{}' becomes a second region '{}' of {}", region.site,
                                 name, rules.name),
                     "rename it");
        continue;
      }
      const double half_height = (std::isinf(region.height) ? kOpenHeight : region.height) / 2;
      const Eigen::Vector2d half = region.half_size;
      const model::Shape shape =
          region.type == model::RegionType::kDisc
              ? model::Shape{model::GeomType::kCylinder, {half.x(), half_height, 0}, nullptr}
              : model::Shape{model::GeomType::kBox, {half.x(), half.y(), half_height}, nullptr};
      AddRegionGeom(name, shape, region.X_BR * model::Pose{.p = {0, 0, half_height}}, region.mark,
                    body);
    }
  }
}

// Drops the free joint of the root, because the host adds its own. Warns if attributes of the joint
// are lost.
void DropFreeJoint(model::Body& root, const TargetRules& rules, diag::Findings& findings) {
  const auto free = std::ranges::find(root.joints, "free", &model::Joint::type);
  if (free == root.joints.end()) return;
  if (!free->attributes.empty()) {
    const auto dropped = diag::Mapped<std::string_view>(free->attributes, &model::Attribute::name);
    findings.Warn(
        Code::kTargetDropped, free->mark,
        fmt::format("{} adds the free joint itself: the attributes of joint '{}' are dropped ({})",
                    rules.name, free->name, JoinNames(dropped)),
        "set them where the object is loaded (joints=...)");
  }
  root.joints.erase(free);
}

// Drops cameras and lights that target the root body, because the host renames that body but not
// the reference to it.
void DropElementsTargetingRoot(model::Object& object, const TargetRules& rules,
                               diag::Findings& findings) {
  const auto targets_root = [&](const model::Element& element) {
    return std::ranges::any_of(element.attributes, [&](const model::Attribute& attribute) {
      return attribute.refers == "body" && attribute.text == rules.root;
    });
  };
  for (model::Body& body : object.bodies) {
    for (const model::Element& element : body.elements) {
      if (!targets_root(element)) continue;
      findings.Warn(Code::kTargetDropped, element.mark,
                    fmt::format("{} renames the root body: {} '{}', which looks at it, is dropped",
                                rules.name, element.tag, element.name));
    }
    std::erase_if(body.elements, targets_root);
  }
}

// Returns true if the object has a single root body; otherwise adds a finding.
bool CheckSingleRoot(const model::Object& object, const TargetRules& rules,
                     diag::Findings& findings) {
  const auto is_other_root = [&](const model::Body& body) {
    return body.parent < 0 && &body != &object.bodies.front();
  };
  const auto found = std::ranges::find_if(object.bodies, is_other_root);
  if (found == object.bodies.end()) return true;
  findings.Add(
      Code::kTargetOneRoot, found->mark,
      fmt::format("{} takes objects of one root, but body '{}' is free", rules.name, found->name),
      "write each object as a file of its own with --each, or use --target mujoco, scene or mjx");
  return false;
}

}  // namespace

void AdaptBodies(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  if (!rules.root.empty() && !CheckSingleRoot(object, rules, findings)) return;
  if (!rules.has_free_joint) DropFreeJoint(object.bodies.front(), rules, findings);
  if (!rules.root.empty()) DropElementsTargetingRoot(object, rules, findings);
  if (rules.has_region_geoms) AddRegionGeoms(object, rules, findings);
  if (rules.has_outer_body) PutIntoOuterBody(object);
}

}  // namespace mjforge::mjcf
