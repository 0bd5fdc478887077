// Looks up attributes of elements in their default classes.
#include "mjforge/backport/default_classes.h"

#include <algorithm>
#include <iterator>

#include "mjforge/backport/mjcf_versions.h"

namespace mjforge::backport {
namespace {

/// Returns true for elements to which no defaults apply: free joints, inertials, and the elements
/// of a tendon's path.
bool HasNoDefaults(std::string_view parent, std::string_view tag) {
  return parent == "fixed" || parent == "spatial" || tag == "freejoint" || tag == "inertial";
}

}  // namespace

DefaultClasses::DefaultClasses(xml::XmlElement& root) {
  for (xml::XmlElement& section : root.children) {
    if (section.tag != "default") continue;
    if (const std::string* name = section.Find("class")) main_ = *name;
    ReadClass(section, "", "");
  }
  Place(root, "");
}

void DefaultClasses::ReadClass(const xml::XmlElement& section, const std::string& name,
                               const std::string& parent) {
  Class& read = classes_[name];
  read.parent = parent;
  for (const xml::XmlElement& child : section.children) {
    if (child.tag != "default") read.elements.push_back(&child);
  }
  for (const xml::XmlElement& child : section.children) {
    const std::string* inner = child.Find("class");
    if (child.tag == "default" && inner != nullptr) ReadClass(child, *inner, name);
  }
}

void DefaultClasses::Place(xml::XmlElement& parent, const std::string& child_class) {
  for (xml::XmlElement& child : parent.children) {
    if (child.tag == "default") continue;
    const std::string* own = child.Find("class");
    ClassedElement classed{&child, &parent, ElementKindOf(parent.tag, child.tag),
                           own == nullptr ? child_class : *own};
    if (classed.default_class == main_) classed.default_class.clear();
    if (HasNoDefaults(parent.tag, child.tag)) classed.kind = {};
    elements_.push_back(classed);
    const std::string* inner = child.Find("childclass");
    Place(child, inner == nullptr ? child_class : *inner);
  }
}

std::vector<ClassedElement*> DefaultClasses::In(std::string_view kind) {
  std::vector<ClassedElement*> found;
  for (ClassedElement& classed : elements_) {
    if (classed.kind == kind) found.push_back(&classed);
  }
  return found;
}

std::vector<const xml::XmlElement*> DefaultClasses::DefaultsOf(
    const ClassedElement& classed) const {
  std::vector<const xml::XmlElement*> found;
  if (classed.kind.empty()) return found;
  std::string name = classed.default_class;
  while (true) {
    const auto entry = classes_.find(name);
    if (entry == classes_.end()) break;  // MuJoCo rejects the unknown class
    const std::vector<const xml::XmlElement*>& elements = entry->second.elements;
    std::copy_if(elements.rbegin(), elements.rend(), std::back_inserter(found),
                 [&](const xml::XmlElement* element) {
                   return ElementKindOf("default", element->tag) == classed.kind;
                 });
    if (name.empty()) break;
    name = entry->second.parent;
  }
  std::ranges::reverse(found);
  return found;
}

const std::string* DefaultClasses::Find(const ClassedElement& classed,
                                        std::string_view attribute) const {
  const std::string* text = classed.element->Find(attribute);
  if (text != nullptr) return text;
  for (const xml::XmlElement* element : DefaultsOf(classed)) {
    if (const std::string* said = element->Find(attribute)) text = said;
  }
  return text;
}

std::string DefaultClasses::Get(const ClassedElement& classed, std::string_view attribute,
                                std::string_view otherwise) const {
  const std::string* text = Find(classed, attribute);
  return text == nullptr ? std::string(otherwise) : *text;
}

std::string DefaultClasses::Setting(std::string_view attribute, std::string_view otherwise) const {
  std::string value(otherwise);
  for (const ClassedElement& classed : elements_) {
    if (classed.kind != "compiler") continue;
    if (const std::string* said = classed.element->Find(attribute)) value = *said;
  }
  return value;
}

}  // namespace mjforge::backport
