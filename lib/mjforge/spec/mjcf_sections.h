// MJCF sections that a spec may contain under `mjcf:`, with their elements and attributes.

#pragma once

#include <span>
#include <string_view>

#include "mjforge/spec/fields.h"

namespace mjforge::spec {

/// A section of MJCF that `mjcf:` accepts.
struct SectionInfo {
  std::string_view name;  // "sensor"
  /// True if the section is a single element with attributes (`option`), not a list of elements.
  bool is_element = false;
  /// The allowed elements. If `is_element` is true, the list contains only the section itself.
  std::span<const ElementInfo> elements;

  const ElementInfo* Find(std::string_view element) const;
};
/// Returns the sections in their order in MJCF files. Source: mj_printSchema of MuJoCo 2.2.2.
std::span<const SectionInfo> Sections();
const SectionInfo* FindSection(std::string_view name);
/// Returns the element `camera` or `light` of a body; null for other names.
const ElementInfo* FindBodyChild(std::string_view name);

}  // namespace mjforge::spec
