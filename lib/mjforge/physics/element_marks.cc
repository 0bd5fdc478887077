// Lookup of parts, joints and other elements of an object by name, and of their places in the spec.
#include "mjforge/physics/element_marks.h"

#include <algorithm>

namespace mjforge::physics {

const model::Part* PartOf(const model::Object& object, std::string_view geom) {
  for (const model::Body& body : object.bodies) {
    const auto found = std::ranges::find(body.parts, geom, &model::Part::name);
    if (found != body.parts.end()) return &*found;
  }
  return nullptr;
}

diag::SourceMark PartMark(const model::Part* part, diag::SourceMark usual) {
  return part != nullptr && part->mark ? part->mark : usual;
}

diag::SourceMark BodyMark(const model::Object& object, std::string_view name,
                          diag::SourceMark usual) {
  const auto found = std::ranges::find(object.bodies, name, &model::Body::name);
  return found != object.bodies.end() && found->mark ? found->mark : usual;
}

diag::SourceMark JointMark(const model::Object& object, std::string_view name,
                           diag::SourceMark usual) {
  for (const model::Body& body : object.bodies) {
    const auto found = std::ranges::find(body.joints, name, &model::Joint::name);
    if (found != body.joints.end() && found->mark) return found->mark;
  }
  return usual;
}

diag::SourceMark ElementMark(const model::Object& object, std::string_view section,
                             std::string_view name, diag::SourceMark usual) {
  const auto elements = model::ElementsOf(object, section);
  const auto found = std::ranges::find(elements, name, &model::Element::name);
  return found != elements.end() && found->mark ? found->mark : usual;
}

}  // namespace mjforge::physics
