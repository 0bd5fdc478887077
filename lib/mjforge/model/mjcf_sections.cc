// Access to MJCF attributes and elements that are copied without interpretation: attributes by
// name, sections of an object, and names without the object's prefix.

#include "mjforge/model/object.h"

namespace mjforge::model {

void AddUnlessPresent(Attribute attribute, std::vector<Attribute>& attributes) {
  if (FindAttribute(attributes, attribute.name) == nullptr)
    attributes.push_back(std::move(attribute));
}

Eigen::Vector3d VectorOf(const Element& element, std::string_view name,
                         const Eigen::Vector3d& usual) {
  const Attribute* attribute = FindAttribute(element.attributes, name);
  const bool has_numbers = attribute != nullptr && attribute->numbers.size() >= 3;
  return has_numbers ? Eigen::Vector3d(attribute->numbers.data()) : usual;
}

Eigen::Quaterniond QuaternionOf(const Element& element) {
  const Attribute* quat = FindAttribute(element.attributes, "quat");
  if (quat == nullptr || quat->numbers.size() < 4) return Eigen::Quaterniond::Identity();
  const AttributeNumbers& wxyz = quat->numbers;
  return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]};
}

std::string_view KindOf(const Attribute& attribute, const Element& element) {
  if (!attribute.refers.starts_with('@')) return attribute.refers;
  return TextOf(element, attribute.refers.substr(1), attribute.refers);
}

std::span<const Element> ElementsOf(const Object& object, std::string_view section) {
  for (const Section& one : object.sections) {
    if (one.info->name == section) return one.elements;
  }
  return {};
}

std::vector<Element>& ElementsOf(const spec::SectionInfo& info, std::vector<Section>& sections) {
  const auto found = std::ranges::find(sections, &info, &Section::info);
  return found != sections.end() ? found->elements
                                 : sections.emplace_back(Section{&info, {}}).elements;
}

std::string_view OwnName(std::string_view name, std::string_view object) {
  const bool has_prefix = name.starts_with(object) && name.substr(object.size()).starts_with('_');
  return has_prefix ? name.substr(object.size() + 1) : name;
}

}  // namespace mjforge::model
