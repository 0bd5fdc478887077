#pragma once

// MJCF that mjforge carries without interpreting it.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"

namespace mjforge::model {

using spec::Applies;  // for rooms to the right, which do not know specs

/// One MJCF attribute that mjforge carries without interpreting it: its numbers
/// or, if there are none, its text.
struct Attribute {
  std::string_view name;  // of the field table: lives forever
  Applies applies = Applies::kBoth;
  sample::Numbers numbers;
  std::string text;
  std::string_view refers = {};  // kind of element the text names; see spec::FieldInfo

  bool operator==(const Attribute&) const = default;
};

/// An MJCF element that mjforge carries whole: a sensor, a camera.
struct Element {
  std::string_view tag;  // of the section table: lives forever
  std::string name;      // empty: it has none
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  diag::SourceMark mark;
};

/// The elements of one section (contact, sensor, ...).
struct Section {
  const spec::SectionInfo* info = nullptr;
  std::vector<Element> elements;
};

}  // namespace mjforge::model
