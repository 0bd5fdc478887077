// MJCF attributes and elements that mjforge carries without interpreting them.

#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"

namespace mjforge::model {

using spec::Applies;  // for rooms that may not name `spec`

/// An MJCF attribute: its numbers or, if there are none, its text.
struct Attribute {
  std::string_view name;  // static storage: the field table
  Applies applies = Applies::kBoth;
  sample::Numbers numbers;
  std::string text;
  std::string_view refers = {};  // kind of element that the text names; see spec::FieldInfo

  bool operator==(const Attribute&) const = default;
};

/// Returns a pointer to the attribute of that name, or null.
template <typename Attributes>
auto* FindAttribute(Attributes& attributes, std::string_view name) {
  const auto found = std::ranges::find(attributes, name, &Attribute::name);
  return found == attributes.end() ? nullptr : &*found;
}

/// An MJCF element that is carried whole, such as a sensor or a camera.
struct Element {
  std::string_view tag;  // static storage: the section table
  std::string name;      // empty if it has none
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  diag::SourceMark mark;
};

/// Returns the kind of element that an attribute of `element` refers to; for `@objtype`, the value
/// of the attribute objtype.
std::string_view KindOf(const Attribute& attribute, const Element& element);

/// The elements of one section of MJCF (contact, sensor, ...).
struct Section {
  const spec::SectionInfo* info = nullptr;
  std::vector<Element> elements;
};

}  // namespace mjforge::model
