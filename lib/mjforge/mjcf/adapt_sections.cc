// Removal of sections, elements and texture files that a target does not support.

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "mjforge/mjcf/adapt.h"

namespace mjforge::mjcf {
namespace {

using diag::Code;
using model::Attribute;
using model::Element;
using model::Section;

// Returns the quoted name of an element or, if it has no name, its tag and references: "exclude of
// 'base' and 'lid'". Replaces `root`, the root body's name for the host, by `object`, the name that
// the user knows.
std::string Describe(const Element& element, std::string_view root = {},
                     std::string_view object = {}) {
  if (!element.name.empty()) return fmt::format("'{}'", element.name);
  std::string text(element.tag);
  std::string_view joint = " of ";
  for (const Attribute& attribute : element.attributes) {
    if (attribute.refers.empty()) continue;
    const std::string_view name = attribute.text == root ? object : attribute.text;
    text += fmt::format("{}'{}'", std::exchange(joint, " and "), name);
  }
  return text;
}

// Returns tag and name of an element, "jointpos 'angle'"; without a name, tag and references.
std::string DescribeWithTag(const Element& element) {
  return element.name.empty() ? Describe(element)
                              : fmt::format("{} '{}'", element.tag, element.name);
}

void DropSections(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  for (const Section& section : object.sections) {
    if (section.elements.empty()) continue;
    std::vector<std::string> described;
    for (const Element& element : section.elements)
      described.push_back(Describe(element, rules.root, object.name));
    const std::vector<std::string_view> names(described.begin(), described.end());
    const std::string what =
        section.info->is_element
            ? fmt::format("'{}' is dropped", section.info->name)
            : fmt::format("{} of '{}' {} dropped ({})", diag::Counted(names.size(), "element"),
                          section.info->name, names.size() == 1 ? "is" : "are", JoinNames(names));
    findings.Warn(Code::kTargetDropped, section.elements.front().mark,
                  fmt::format("{} reads only the body and its assets: {}", rules.name, what),
                  "add it where the object is put into a task");
  }
  object.sections.clear();
}

// Drops elements and attributes that the target does not support (TargetRules::unsupported), and
// elements that refer to dropped elements.
class UnsupportedFilter {
 public:
  UnsupportedFilter(const TargetRules& rules, diag::Findings& findings)
      : rules_(rules), findings_(findings) {}

  void Run(std::vector<Section>& sections) {
    for (Section& section : sections) DropUnsupported(section.info->name, section.elements);
    // Drops elements that refer to dropped elements, such as the sensors of a dropped actuator.
    for (Section& section : sections) DropReferences(section.elements);
    std::erase_if(sections, [](const Section& section) { return section.elements.empty(); });
  }

 private:
  static bool Matches(const UnsupportedFeature& feature, const Attribute& attribute) {
    if (attribute.name != feature.attribute) return false;
    if (!feature.text.empty()) return attribute.text == feature.text;
    if (!attribute.numbers.empty()) return attribute.numbers[0] != 0;
    return attribute.text != "disable" && !attribute.text.empty();
  }

  // Drops unsupported elements of a section at every depth, and unsupported attributes.
  void DropUnsupported(std::string_view section, std::vector<Element>& elements) {
    std::erase_if(elements, [&](const Element& element) {
      const bool is_dropped = IsUnsupported(section, element);
      if (is_dropped) ReportDropped(section, element);
      return is_dropped;
    });
    for (Element& element : elements) {
      for (const UnsupportedFeature& feature : rules_.unsupported) {
        if (!feature.drops_element && AppliesTo(feature, section, element))
          DropAttribute(feature, element);
      }
      DropUnsupported(section, element.children);
    }
  }

  static bool AppliesTo(const UnsupportedFeature& feature, std::string_view section,
                        const Element& element) {
    return feature.section == section &&
           (feature.element.empty() || feature.element == element.tag);
  }

  bool IsUnsupported(std::string_view section, const Element& element) const {
    return std::ranges::any_of(rules_.unsupported, [&](const UnsupportedFeature& feature) {
      if (!feature.drops_element || !AppliesTo(feature, section, element)) return false;
      return feature.attribute.empty() ||
             std::ranges::any_of(element.attributes, [&](const Attribute& attribute) {
               return Matches(feature, attribute);
             });
    });
  }

  void DropAttribute(const UnsupportedFeature& feature, Element& element) {
    std::erase_if(element.attributes, [&](const Attribute& attribute) {
      const bool is_dropped = Matches(feature, attribute);
      if (is_dropped) {
        findings_.Warn(
            Code::kTargetDropped, element.mark,
            fmt::format("{} has no {}{}{}: it is dropped from {}", rules_.name, attribute.name,
                        feature.text.empty() ? "" : " ", feature.text, DescribeWithTag(element)));
      }
      return is_dropped;
    });
  }

  void ReportDropped(std::string_view section, const Element& element) {
    findings_.Warn(Code::kTargetDropped, element.mark,
                   fmt::format("{} does not have this kind of {}: {} is dropped", rules_.name,
                               section, DescribeWithTag(element)));
    if (element.name.empty()) return;
    dropped_.emplace(section, element.name);
  }

  void DropReferences(std::vector<Element>& elements) {
    std::erase_if(elements, [&](const Element& element) {
      const Attribute* dangling = DanglingReference(element);
      if (dangling == nullptr) return false;
      findings_.Warn(Code::kTargetDropped, element.mark,
                     fmt::format("{} is dropped with '{}', which it refers to",
                                 DescribeWithTag(element), dangling->text));
      return true;
    });
  }

  // Returns an attribute that refers to a dropped element; null if there is none.
  const Attribute* DanglingReference(const Element& element) const {
    for (const Attribute& attribute : element.attributes) {
      const std::string kind(model::KindOf(attribute, element));
      if (dropped_.contains({kind, attribute.text})) return &attribute;
    }
    for (const Element& child : element.children) {
      if (const Attribute* dangling = DanglingReference(child)) return dangling;
    }
    return nullptr;
  }

  const TargetRules& rules_;
  diag::Findings& findings_;
  std::set<std::pair<std::string, std::string>> dropped_;  // kind and name of each dropped element
};

// Drops texture files for single sides of a cube, because the host resolves only the attribute
// `file`. A texture without remaining files gets a flat color.
void DropTextureSides(model::Texture& texture, const TargetRules& rules, diag::Findings& findings) {
  const auto is_side = [](const model::TextureFile& file) { return file.attribute != "file"; };
  if (std::ranges::none_of(texture.files, is_side)) return;
  findings.Warn(Code::kTargetDropped, texture.mark,
                fmt::format("{} reads the picture of a texture only from 'file': the sides of "
                            "texture '{}' are dropped",
                            rules.name, texture.name));
  std::erase_if(texture.files, is_side);
  if (!texture.files.empty()) return;
  texture.attributes = {{.name = "type", .text = "cube"},
                        {.name = "builtin", .text = "flat"},
                        {.name = "width", .numbers = {8}},
                        {.name = "height", .numbers = {8}},
                        {.name = "rgb1", .numbers = {0.8, 0.8, 0.8}}};
}

}  // namespace

void AdaptSections(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  if (!rules.supports_sections) DropSections(object, rules, findings);
  if (!rules.unsupported.empty()) UnsupportedFilter(rules, findings).Run(object.sections);
  if (rules.supports_texture_sides) return;
  for (model::Texture& texture : object.textures) DropTextureSides(texture, rules, findings);
}

}  // namespace mjforge::mjcf
