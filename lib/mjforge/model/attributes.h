// MJCF attributes and elements that mjforge copies without interpreting them.

#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"

namespace mjforge::model {

using spec::Applies;  // alias for libraries that must not use namespace `spec`

/// An MJCF attribute and its value: `numbers` or, if `numbers` is empty, `text`.
struct Attribute {
  std::string_view name;  // refers to text in the table of fields
  Applies applies = Applies::kBoth;
  sample::Numbers numbers;
  std::string text;
  std::string_view refers = {};  // kind of element to which the text refers; see FieldInfo

  bool operator==(const Attribute&) const = default;
};

/// Returns the attribute called `name`; null if there is none.
template <typename Attributes>
auto* FindAttribute(Attributes& attributes, std::string_view name) {
  const auto found = std::ranges::find(attributes, name, &Attribute::name);
  return found == attributes.end() ? nullptr : &*found;
}

/// An MJCF element that is copied without interpretation, such as a sensor or a camera.
struct Element {
  std::string_view tag;  // refers to text in the table of sections
  std::string name;      // empty if the element has no name
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  diag::SourceMark mark;
};

/// Returns the kind of element to which an attribute of `element` refers: `refers` or, if `refers`
/// is "@objtype", the value of the attribute objtype of `element`.
std::string_view KindOf(const Attribute& attribute, const Element& element);

/// The elements of one section of MJCF (contact, sensor, ...).
struct Section {
  const spec::SectionInfo* info = nullptr;
  std::vector<Element> elements;
};

}  // namespace mjforge::model
