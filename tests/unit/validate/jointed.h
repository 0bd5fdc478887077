// Objects of several bodies, assembled by hand.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "../mjcf/hand_made.h"

namespace mjforge::jointed {

using hand_made::Line;

/// A box of 5 cm half size on a free joint. The object and its body are called `block`.
inline model::Object Block() {
  model::Object object = hand_made::Empty("block");
  object.bodies[0].name = "block";
  object.bodies[0].parts.push_back(
      hand_made::Solid("block_core", model::GeomType::kBox, {0.05, 0.05, 0.05}, {}, 3));
  hand_made::Weigh(object);
  return object;
}

/// A body with one ball of radius 1 cm, `NAME_ball`, on a joint `NAME_joint` of a
/// type (none: fixed) about or along x. Its mark is on `line`.
inline model::Body& AddBall(model::Object& object, const std::string& name, int parent,
                            const Eigen::Vector3d& pos, std::string_view joint_type,
                            std::uint32_t line) {
  model::Body& body = object.bodies.emplace_back();
  body.name = name;
  body.parent = parent;
  body.X_PB.p = pos;
  body.mark = Line(line);
  body.parts.push_back(
      hand_made::Solid(name + "_ball", model::GeomType::kSphere, {0.01, 0, 0}, {}, line + 1));
  if (!joint_type.empty()) {
    model::Joint& joint = body.joints.emplace_back();
    joint.name = name + "_joint";
    joint.type = joint_type;
    joint.axis = Eigen::Vector3d::UnitX();
    joint.mark = Line(line + 2);
  }
  hand_made::Weigh(object);
  return body;
}

inline model::Attribute Refers(std::string_view name, std::string text, std::string_view kind) {
  return {name, spec::Applies::kBoth, {}, std::move(text), kind};
}

/// Adds an element to a section, and the section if the object does not have it. Must be called in
/// the order of spec::Sections().
inline model::Element& AddElement(model::Object& object, std::string_view section,
                                  std::string_view tag, std::string name, std::uint32_t line) {
  if (object.sections.empty() || object.sections.back().info->name != section) {
    object.sections.push_back({spec::FindSection(section), {}});
  }
  model::Element& element = object.sections.back().elements.emplace_back();
  element.tag = tag;
  element.name = std::move(name);
  element.mark = Line(line);
  return element;
}

}  // namespace mjforge::jointed
