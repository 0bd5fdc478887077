// Sections of MJCF in an object: their elements, and the kinds of elements to which attributes
// refer.

#include "mjforge/model/object.h"

namespace mjforge::model {

std::string_view KindOf(const Attribute& attribute, const Element& element) {
  if (!attribute.refers.starts_with('@')) return attribute.refers;
  const Attribute* kind = FindAttribute(element.attributes, attribute.refers.substr(1));
  return kind == nullptr ? attribute.refers : std::string_view(kind->text);
}

std::span<const Element> ElementsOf(const Object& object, std::string_view section) {
  for (const Section& one : object.sections) {
    if (one.info->name == section) return one.elements;
  }
  return {};
}

}  // namespace mjforge::model
