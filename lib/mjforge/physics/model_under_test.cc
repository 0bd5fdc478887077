// Looks up names of elements of a model, and places of elements in the spec.
#include "mjforge/physics/model_under_test.h"

#include <algorithm>

#include "mjforge/compiled/compiled.h"
#include "mjforge/expr/expr.h"

namespace mjforge::physics {
namespace {

/// Returns the element with this name; null if there is none.
template <typename Elements>
auto* ElementNamed(Elements& elements, std::string_view name) {
  const auto found =
      std::ranges::find_if(elements, [&](const auto& element) { return element.name == name; });
  return found != elements.end() ? &*found : nullptr;
}

template <typename Element>
diag::SourceMark PlaceOf(const Element* element, diag::SourceMark usual) {
  return element != nullptr && element->mark ? element->mark : usual;
}

}  // namespace

std::string ModelTest::BodyName(int body) const { return compiled::NameOf(m, mjOBJ_BODY, body); }

std::string ModelTest::JointName(int joint) const {
  return compiled::NameOf(m, mjOBJ_JOINT, joint);
}

std::string ModelTest::Distance(int joint, double distance) const {
  return expr::DistanceText(m.jnt_type[joint] == mjJNT_SLIDE, distance);
}

const model::Part* ModelTest::PartOf(std::string_view geom) const {
  for (const model::Body& body : object.bodies) {
    if (const model::Part* part = ElementNamed(body.parts, geom)) return part;
  }
  return nullptr;
}

diag::SourceMark ModelTest::PartMark(const model::Part* part) const { return PlaceOf(part, mark); }

diag::SourceMark ModelTest::BodyMark(std::string_view name) const {
  return PlaceOf(ElementNamed(object.bodies, name), mark);
}

diag::SourceMark ModelTest::JointMark(std::string_view name) const {
  return name.empty() ? mark : PlaceOf(model::FindJoint(object, name), mark);
}

diag::SourceMark ModelTest::ElementMark(std::string_view section, std::string_view name) const {
  const auto elements = model::ElementsOf(object, section);
  return PlaceOf(ElementNamed(elements, name), mark);
}

}  // namespace mjforge::physics
