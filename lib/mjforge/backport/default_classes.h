// Elements of an MJCF file, and lookup of the attributes that they inherit from default classes.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// An element outside of `<default>`, with its kind and default class.
struct ClassedElement {
  xml::XmlElement* element = nullptr;
  const xml::XmlElement* parent = nullptr;
  std::string_view kind;      // from ElementKindOf(); empty if no defaults apply
  std::string default_class;  // empty for the main class
};

/// The elements of a file outside of `<default>`, and lookup of their attributes, including those
/// inherited from default classes. Valid as long as no element is added to the tree or removed from
/// it.
class DefaultClasses {
 public:
  explicit DefaultClasses(xml::XmlElement& root);

  std::vector<ClassedElement>& all() { return elements_; }
  /// Returns the elements with this ClassedElement::kind: all actuators for "actuator", all joints
  /// for "joint".
  std::vector<ClassedElement*> In(std::string_view kind);

  /// Returns the value of an attribute of the element, or else of the default classes that apply to
  /// the element; null if none of them sets the attribute.
  const std::string* Find(const ClassedElement& classed, std::string_view attribute) const;
  std::string Get(const ClassedElement& classed, std::string_view attribute,
                  std::string_view otherwise) const;
  /// Returns the value of a compiler setting in the last `<compiler>` that has it; `otherwise` if
  /// none has it.
  std::string Setting(std::string_view attribute, std::string_view otherwise) const;
  /// Returns the elements in `<default>` from which the element inherits attributes, those of the
  /// main class first.
  std::vector<const xml::XmlElement*> DefaultsOf(const ClassedElement& classed) const;

 private:
  void ReadClass(const xml::XmlElement& section, const std::string& name,
                 const std::string& parent);
  void Place(xml::XmlElement& parent, const std::string& child_class);

  struct Class {
    std::string parent;
    std::vector<const xml::XmlElement*> elements;
  };
  std::map<std::string, Class> classes_ = {{"", {}}};
  std::string main_ = "main";
  std::vector<ClassedElement> elements_;
};

}  // namespace mjforge::backport
