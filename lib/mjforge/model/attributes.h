// MJCF attributes and elements that mjforge copies without interpreting them.

#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "mjforge/diag/diag.h"
#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"

namespace mjforge::model {

using spec::Applies;  // alias for libraries that must not use namespace `spec`

/// The numbers of an MJCF attribute. Numbers that are the same in all variants are shared with the
/// spec, which also stores them as text.
class AttributeNumbers {
 public:
  AttributeNumbers() = default;
  AttributeNumbers(std::initializer_list<double> numbers) : own_(numbers) {}
  AttributeNumbers(sample::Numbers numbers) : own_(std::move(numbers)) {}  // NOLINT
  explicit AttributeNumbers(std::shared_ptr<const spec::ConstantValue> constant)
      : constant_(std::move(constant)) {}

  std::size_t size() const { return constant_ ? constant_->numbers.size() : own_.size(); }
  const double* data() const { return constant_ ? constant_->numbers.data() : own_.data(); }
  bool empty() const { return size() == 0; }
  const double* begin() const { return data(); }
  const double* end() const { return data() + size(); }
  double front() const { return *data(); }
  double operator[](std::size_t i) const { return data()[i]; }

  /// Returns shared numbers as MJCF text: "0.5 0.5 1". Returns an empty text for other numbers.
  std::string_view text() const { return constant_ ? std::string_view(constant_->text) : ""; }
  /// Returns the numbers for modification. Copies numbers that are shared with the spec first.
  sample::Numbers& Change() {
    if (constant_) own_.assign(begin(), end());
    constant_.reset();
    return own_;
  }

  bool operator==(const AttributeNumbers& other) const { return std::ranges::equal(*this, other); }

 private:
  std::shared_ptr<const spec::ConstantValue> constant_;
  sample::Numbers own_;  // used if `constant_` is null
};

/// An MJCF attribute and its value: `numbers` or, if `numbers` is empty, `text`.
struct Attribute {
  std::string_view name;  // view of a string in static storage
  Applies applies = Applies::kBoth;
  AttributeNumbers numbers = {};
  std::string text = {};
  std::string_view refers = {};  // kind of element that `text` names; see KindOf(); empty: none

  bool operator==(const Attribute&) const = default;
};

/// Returns the attribute called `name`; null if there is none.
template <typename Attributes>
auto* FindAttribute(Attributes& attributes, std::string_view name) {
  return diag::Find(attributes, name, &Attribute::name);
}

/// Adds an attribute unless `attributes` contains one with the same name.
void AddUnlessPresent(Attribute attribute, std::vector<Attribute>& attributes);

/// Sets the numbers of the attribute called `name`; adds this attribute if it is missing. `name`
/// must be in static storage.
template <typename Range = sample::Numbers>
void SetNumbers(std::vector<Attribute>& attributes, std::string_view name, const Range& numbers) {
  Attribute* attribute = FindAttribute(attributes, name);
  if (attribute == nullptr) attribute = &attributes.emplace_back();
  attribute->name = name;
  attribute->numbers.Change().assign(numbers.begin(), numbers.end());
}

/// Returns the number at index `position` of the attribute called `name`. `owner` is a struct with
/// a member `attributes`. Returns `usual` if the attribute is missing or has too few numbers.
template <typename Owner>
double NumberOf(const Owner& owner, std::string_view name, std::size_t position, double usual) {
  const Attribute* attribute = FindAttribute(owner.attributes, name);
  const bool has_number = attribute != nullptr && position < attribute->numbers.size();
  return has_number ? attribute->numbers[position] : usual;
}

/// Returns the text of an attribute; `usual` if `owner` does not have the attribute.
template <typename Owner>
std::string_view TextOf(const Owner& owner, std::string_view name, std::string_view usual = {}) {
  const Attribute* attribute = FindAttribute(owner.attributes, name);
  return attribute == nullptr ? usual : std::string_view(attribute->text);
}

/// An MJCF element that is copied without interpretation, such as a sensor or a camera.
struct Element {
  std::string_view tag;  // view of a string in the table of sections (spec/mjcf_sections.cc)
  std::string name;      // empty if the element has no name
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  diag::SourceMark mark;
};

/// Returns the first three numbers of an attribute; `usual` if the element does not have the
/// attribute or the attribute has fewer numbers.
Eigen::Vector3d VectorOf(const Element& element, std::string_view name,
                         const Eigen::Vector3d& usual = Eigen::Vector3d::Zero());

/// Returns the attribute `quat`; the identity if it is missing or has fewer than four numbers.
Eigen::Quaterniond QuaternionOf(const Element& element);

/// Returns the kind of element ("joint", "body") that an attribute of `element` names: `refers` or,
/// if `refers` begins with "@", the text of another attribute of `element` ("@objtype": objtype).
std::string_view KindOf(const Attribute& attribute, const Element& element);

/// Calls `visit` with the kind and the text of each attribute of an element and its descendants
/// that names another element.
template <typename AnyElement, typename Visit>
void ForEachReference(AnyElement& element, const Visit& visit) {
  for (auto& attribute : element.attributes) {
    if (!attribute.refers.empty()) visit(KindOf(attribute, element), attribute.text);
  }
  for (auto& child : element.children) ForEachReference(child, visit);
}

/// Returns an element's name as written in the spec: `name` without the prefix "OBJECT_", where
/// OBJECT is the object's name; `name` itself if it does not have this prefix.
std::string_view OwnName(std::string_view name, std::string_view object);

/// The elements of one section of MJCF (contact, sensor, ...).
struct Section {
  const spec::SectionInfo* info = nullptr;
  std::vector<Element> elements;
};

/// Returns the elements of a section; adds the section if it is missing.
std::vector<Element>& ElementsOf(const spec::SectionInfo& info, std::vector<Section>& sections);

}  // namespace mjforge::model
