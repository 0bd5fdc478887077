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

/// Its name, or what it is about: "exclude of 'base' and 'lid'". A reference to
/// the root, whose name is the host's, is shown as one to the object.
std::string Described(const Element& element, std::string_view root = {},
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

/// "jointpos 'angle'".
std::string Called(const Element& element) {
  return element.name.empty() ? Described(element)
                              : fmt::format("{} '{}'", element.tag, element.name);
}

void DropSections(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  for (const Section& section : object.sections) {
    if (section.elements.empty()) continue;
    std::vector<std::string> described;
    for (const Element& element : section.elements)
      described.push_back(Described(element, rules.root, object.name));
    const std::vector<std::string_view> names(described.begin(), described.end());
    const std::string what = section.info->is_element
                                 ? fmt::format("'{}' is dropped", section.info->name)
                                 : fmt::format("{} element{} of '{}' {} dropped ({})", names.size(),
                                               names.size() == 1 ? "" : "s", section.info->name,
                                               names.size() == 1 ? "is" : "are", Listed(names));
    findings.Warn(Code::kTargetDropped, section.elements.front().mark,
                  fmt::format("{} reads only the body and its assets: {}", rules.name, what),
                  "add it where the object is put into a task");
  }
  object.sections.clear();
}

class Sieve {
 public:
  Sieve(const TargetRules& rules, diag::Findings& findings) : rules_(rules), findings_(findings) {}

  void Run(std::vector<Section>& sections) {
    for (Section& section : sections) Pass(section.info->name, section.elements);
    // A sensor of a dropped actuator goes with it.
    while (std::exchange(dropped_more_, false)) {
      for (Section& section : sections) PassReferences(section.elements);
    }
    std::erase_if(sections, [](const Section& section) { return section.elements.empty(); });
  }

 private:
  static bool Matches(const Refusal& refusal, const Attribute& attribute) {
    if (attribute.name != refusal.attribute) return false;
    if (!refusal.word.empty()) return attribute.text == refusal.word;
    if (!attribute.numbers.empty()) return attribute.numbers[0] != 0;
    return attribute.text != "disable" && !attribute.text.empty();
  }

  // `section` and the elements in it, those inside them included.
  void Pass(std::string_view section, std::vector<Element>& elements) {
    std::erase_if(elements, [&](const Element& element) {
      const bool refused = IsRefused(section, element);
      if (refused) Drop(section, element);
      return refused;
    });
    for (Element& element : elements) {
      for (const Refusal& refusal : rules_.refusals) {
        if (!refusal.whole && IsAbout(refusal, section, element)) Strip(refusal, element);
      }
      Pass(section, element.children);
    }
  }

  static bool IsAbout(const Refusal& refusal, std::string_view section, const Element& element) {
    return refusal.section == section &&
           (refusal.element.empty() || refusal.element == element.tag);
  }

  bool IsRefused(std::string_view section, const Element& element) const {
    return std::ranges::any_of(rules_.refusals, [&](const Refusal& refusal) {
      if (!refusal.whole || !IsAbout(refusal, section, element)) return false;
      return refusal.attribute.empty() ||
             std::ranges::any_of(element.attributes, [&](const Attribute& attribute) {
               return Matches(refusal, attribute);
             });
    });
  }

  void Strip(const Refusal& refusal, Element& element) {
    std::erase_if(element.attributes, [&](const Attribute& attribute) {
      const bool refused = Matches(refusal, attribute);
      if (refused) {
        findings_.Warn(
            Code::kTargetDropped, element.mark,
            fmt::format("{} has no {}{}{}: it is dropped from {}", rules_.name, attribute.name,
                        refusal.word.empty() ? "" : " ", refusal.word, Called(element)));
      }
      return refused;
    });
  }

  void Drop(std::string_view section, const Element& element) {
    findings_.Warn(Code::kTargetDropped, element.mark,
                   fmt::format("{} does not have this kind of {}: {} is dropped", rules_.name,
                               section, Called(element)));
    if (element.name.empty()) return;
    dropped_.emplace(section, element.name);
    dropped_more_ = true;
  }

  void PassReferences(std::vector<Element>& elements) {
    std::erase_if(elements, [&](const Element& element) {
      const Attribute* lost = LostReference(element);
      if (lost == nullptr) return false;
      findings_.Warn(
          Code::kTargetDropped, element.mark,
          fmt::format("{} is dropped with '{}', which it refers to", Called(element), lost->text));
      return true;
    });
  }

  const Attribute* LostReference(const Element& element) const {
    for (const Attribute& attribute : element.attributes) {
      std::string_view kind = attribute.refers;
      for (const Attribute& other : element.attributes) {
        if (kind.starts_with('@') && other.name == kind.substr(1)) kind = other.text;
      }
      if (dropped_.contains({std::string(kind), attribute.text})) return &attribute;
    }
    for (const Element& child : element.children) {
      if (const Attribute* lost = LostReference(child)) return lost;
    }
    return nullptr;
  }

  const TargetRules& rules_;
  diag::Findings& findings_;
  std::set<std::pair<std::string, std::string>> dropped_;  // kind, name
  bool dropped_more_ = false;
};

// The host finds the file of a picture, but not those of six. A texture that
// has lost them is one colour.
void DropPictureSides(model::Texture& texture, const TargetRules& rules, diag::Findings& findings) {
  const auto is_side = [](const model::TextureFile& file) { return file.attribute != "file"; };
  if (std::ranges::none_of(texture.files, is_side)) return;
  findings.Warn(Code::kTargetDropped, texture.mark,
                fmt::format("{} reads the picture of a texture only from 'file': the sides of "
                            "texture '{}' are dropped",
                            rules.name, texture.name));
  std::erase_if(texture.files, is_side);
  if (!texture.files.empty()) return;
  const auto word = [](std::string_view name, std::string text) {
    return Attribute{name, model::Applies::kBoth, {}, std::move(text)};
  };
  const auto number = [](std::string_view name, double value) {
    return Attribute{name, model::Applies::kBoth, {value}, {}};
  };
  texture.attributes = {word("type", "cube"),
                        word("builtin", "flat"),
                        number("width", 8),
                        number("height", 8),
                        {"rgb1", model::Applies::kBoth, {0.8, 0.8, 0.8}, {}}};
}

}  // namespace

void AdaptSections(model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  if (!rules.sections) DropSections(object, rules, findings);
  if (!rules.refusals.empty()) Sieve(rules, findings).Run(object.sections);
  if (rules.picture_sides) return;
  for (model::Texture& texture : object.textures) DropPictureSides(texture, rules, findings);
}

}  // namespace mjforge::mjcf
