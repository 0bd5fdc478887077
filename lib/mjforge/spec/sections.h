#pragma once

// The MJCF sections that pass through: elements, attributes, references.

#include <span>
#include <string_view>

#include "mjforge/spec/fields.h"

namespace mjforge::spec {

/// A section of MJCF that `mjcf:` accepts.
struct SectionInfo {
  std::string_view name;  // "sensor"
  /// The section is one element with its own attributes (`option`), not a list.
  bool is_element = false;
  /// The elements it may contain; if `is_element`, the first is the section itself.
  std::span<const ElementInfo> elements;

  const ElementInfo* Find(std::string_view element) const;
};
/// In the order MJCF files have them. Source: mj_printSchema of MuJoCo 2.2.2.
std::span<const SectionInfo> Sections();
const SectionInfo* FindSection(std::string_view name);
/// What a body may contain besides geoms, joints and sites: camera, light.
const ElementInfo* FindBodyChild(std::string_view name);

}  // namespace mjforge::spec
