#include "mjforge/engine/older_rules.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/engine/placed_elements.h"

namespace mjforge::engine {
namespace {

constexpr std::pair<std::string_view, std::string_view> kLimits[] = {{"range", "limited"},
                                                                     {"ctrlrange", "ctrllimited"},
                                                                     {"forcerange", "forcelimited"},
                                                                     {"actrange", "actlimited"}};

/// Whether anything says a range, and not whether that limits.
bool NeedsLimits(const XmlElement& element) {
  const auto lacks = [&](const auto& limit) {
    return element.Find(limit.first) != nullptr && element.Find(limit.second) == nullptr;
  };
  return std::ranges::any_of(kLimits, lacks) || std::ranges::any_of(element.children, NeedsLimits);
}

/// A range limits, as in every release since 3.0. With their usual setting, those before refuse
/// each file in which that makes a difference.
bool ImplyLimits(XmlElement& root) {
  const auto is_compiler = [](const XmlElement& section) { return section.tag == "compiler"; };
  for (const XmlElement& section : root.children) {
    if (is_compiler(section) && section.Find("autolimits") != nullptr) return false;
  }
  if (!NeedsLimits(root)) return false;
  auto compiler = std::ranges::find_if(root.children, is_compiler);
  if (compiler == root.children.end()) {
    compiler = root.children.emplace(root.children.begin());
    compiler->tag = "compiler";
    compiler->mark = root.mark;
  }
  compiler->Set("autolimits", "true");
  return true;
}

bool HasState(const PlacedElements& elements, const Placed& actuator) {
  const std::string& tag = actuator.element->tag;
  if (tag == "intvelocity" || tag == "cylinder" || tag == "muscle") return true;
  return tag == "general" && elements.Get(actuator, "dyntype", "none") != "none";
}

/// Actuators with a state come last, else in the order of the file.
bool OrderActuators(XmlElement& root) {
  std::set<const XmlElement*> stateful;
  PlacedElements elements(root);
  for (const Placed* actuator : elements.In("actuator")) {
    if (HasState(elements, *actuator)) stateful.insert(actuator->element);
  }
  bool changed = false;
  for (XmlElement& section : root.children) {
    if (section.tag != "actuator") continue;
    std::vector<XmlElement> first;
    std::vector<XmlElement> last;
    for (XmlElement& child : section.children) {
      const bool is_last = stateful.contains(&child);
      changed |= !is_last && !last.empty();
      (is_last ? last : first).push_back(std::move(child));
    }
    section.children = std::move(first);
    std::ranges::move(last, std::back_inserter(section.children));
  }
  return changed;
}

/// The range of controls, which two kinds of actuators must say themselves.
bool CopyRanges(XmlElement& root) {
  bool changed = false;
  PlacedElements elements(root);
  for (Placed* actuator : elements.In("actuator")) {
    XmlElement& element = *actuator->element;
    if (element.tag != "adhesion" && element.tag != "damper") continue;
    const std::string* range = elements.Find(*actuator, "ctrlrange");
    if (range == nullptr || element.Find("ctrlrange") != nullptr) continue;
    element.Set("ctrlrange", std::string(*range));
    changed = true;
  }
  return changed;
}

}  // namespace

bool KeepOlderRules(XmlElement& root, int version) {
  bool changed = false;
  if (version < 231) changed = OrderActuators(root) || changed;
  if (version < 300) {
    changed = CopyRanges(root) || changed;
    changed = ImplyLimits(root) || changed;
  }
  return changed;
}

}  // namespace mjforge::engine
