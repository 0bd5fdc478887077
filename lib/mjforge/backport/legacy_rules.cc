// Meets requirements of older MuJoCo releases on range limits, on the order of actuators, and on
// control ranges.
#include "mjforge/backport/legacy_rules.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/backport/default_classes.h"

namespace mjforge::backport {
namespace {

constexpr std::pair<std::string_view, std::string_view> kLimits[] = {{"range", "limited"},
                                                                     {"ctrlrange", "ctrllimited"},
                                                                     {"forcerange", "forcelimited"},
                                                                     {"actrange", "actlimited"}};

/// Returns true if the element or any descendant has a range without the attribute that enables it.
bool NeedsLimits(const xml::XmlElement& element) {
  const auto lacks = [&](const auto& limit) {
    return element.Find(limit.first) != nullptr && element.Find(limit.second) == nullptr;
  };
  return std::ranges::any_of(kLimits, lacks) || std::ranges::any_of(element.children, NeedsLimits);
}

/// Sets `autolimits` to true, the default since 3.0, if the file has ranges without `limited`.
/// Older releases reject such ranges without this setting.
bool ImplyLimits(xml::XmlElement& root) {
  const auto is_compiler = [](const xml::XmlElement& section) { return section.tag == "compiler"; };
  for (const xml::XmlElement& section : root.children) {
    if (is_compiler(section) && section.Find("autolimits") != nullptr) return false;
  }
  if (!NeedsLimits(root)) return false;
  auto compiler = std::ranges::find_if(root.children, is_compiler);
  if (compiler == root.children.end()) {
    compiler = root.children.insert(root.children.begin(), {.tag = "compiler", .mark = root.mark});
  }
  compiler->Set("autolimits", "true");
  return true;
}

bool HasState(const DefaultClasses& elements, const ClassedElement& actuator) {
  const std::string& tag = actuator.element->tag;
  if (tag == "intvelocity" || tag == "cylinder" || tag == "muscle") return true;
  return tag == "general" && elements.Get(actuator, "dyntype", "none") != "none";
}

/// Moves actuators with an activation state behind all other actuators; otherwise keeps the order
/// of the file. Returns true if the order changed.
bool OrderActuators(xml::XmlElement& root) {
  std::set<const xml::XmlElement*> stateful;
  DefaultClasses elements(root);
  for (const ClassedElement* actuator : elements.In("actuator")) {
    if (HasState(elements, *actuator)) stateful.insert(actuator->element);
  }
  bool changed = false;
  for (xml::XmlElement& section : root.children) {
    if (section.tag != "actuator") continue;
    std::vector<xml::XmlElement> first;
    std::vector<xml::XmlElement> last;
    for (xml::XmlElement& child : section.children) {
      const bool is_last = stateful.contains(&child);
      changed |= !is_last && !last.empty();
      (is_last ? last : first).push_back(std::move(child));
    }
    section.children = std::move(first);
    std::ranges::move(last, std::back_inserter(section.children));
  }
  return changed;
}

/// Copies `ctrlrange` from default classes into adhesion and damper actuators, because older
/// releases require the attribute in the actuator itself.
bool CopyRanges(xml::XmlElement& root) {
  bool changed = false;
  DefaultClasses elements(root);
  for (ClassedElement* actuator : elements.In("actuator")) {
    xml::XmlElement& element = *actuator->element;
    if (element.tag != "adhesion" && element.tag != "damper") continue;
    const std::string* range = elements.Find(*actuator, "ctrlrange");
    if (range == nullptr || element.Find("ctrlrange") != nullptr) continue;
    element.Set("ctrlrange", std::string(*range));
    changed = true;
  }
  return changed;
}

}  // namespace

bool ApplyLegacyRules(xml::XmlElement& root, int version) {
  bool changed = false;
  if (version < 231) changed = OrderActuators(root) || changed;
  if (version < 300) {
    changed = CopyRanges(root) || changed;
    changed = ImplyLimits(root) || changed;
  }
  return changed;
}

}  // namespace mjforge::backport
