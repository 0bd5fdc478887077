#include "mjforge/engine/placed_elements.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mjforge/engine/later_mjcf.h"

namespace mjforge::engine {
namespace {

/// Some share only their tag with what has defaults.
bool HasNoDefaults(std::string_view parent, std::string_view tag) {
  return parent == "fixed" || parent == "spatial" || tag == "freejoint" || tag == "inertial";
}

}  // namespace

PlacedElements::PlacedElements(XmlElement& root) {
  for (XmlElement& section : root.children) {
    if (section.tag != "default") continue;
    if (const std::string* name = section.Find("class")) main_ = *name;
    ReadClass(section, "", "");
  }
  Place(root, "");
}

void PlacedElements::ReadClass(const XmlElement& section, const std::string& name,
                               const std::string& parent) {
  Class& read = classes_[name];
  read.parent = parent;
  for (const XmlElement& child : section.children) {
    if (child.tag != "default") read.elements.push_back(&child);
  }
  for (const XmlElement& child : section.children) {
    const std::string* inner = child.Find("class");
    if (child.tag == "default" && inner != nullptr) ReadClass(child, *inner, name);
  }
}

void PlacedElements::Place(XmlElement& parent, const std::string& child_class) {
  for (XmlElement& child : parent.children) {
    if (child.tag == "default") continue;
    const std::string* own = child.Find("class");
    Placed placed{&child, &parent, SectionOf(parent.tag, child.tag),
                  own == nullptr ? child_class : *own};
    if (placed.default_class == main_) placed.default_class.clear();
    if (HasNoDefaults(parent.tag, child.tag)) placed.section = {};
    placed_.push_back(placed);
    const std::string* inner = child.Find("childclass");
    Place(child, inner == nullptr ? child_class : *inner);
  }
}

std::vector<Placed*> PlacedElements::In(std::string_view section) {
  std::vector<Placed*> found;
  for (Placed& placed : placed_) {
    if (placed.section == section) found.push_back(&placed);
  }
  return found;
}

std::vector<const XmlElement*> PlacedElements::DefaultsOf(const Placed& placed) const {
  std::vector<const XmlElement*> found;
  if (placed.section.empty()) return found;
  std::string name = placed.default_class;
  while (true) {
    const auto entry = classes_.find(name);
    if (entry == classes_.end()) break;  // MuJoCo will say so
    const std::vector<const XmlElement*>& elements = entry->second.elements;
    std::copy_if(elements.rbegin(), elements.rend(), std::back_inserter(found),
                 [&](const XmlElement* element) {
                   return SectionOf("default", element->tag) == placed.section;
                 });
    if (name.empty()) break;
    name = entry->second.parent;
  }
  std::ranges::reverse(found);
  return found;
}

const std::string* PlacedElements::Find(const Placed& placed, std::string_view attribute) const {
  const std::string* text = placed.element->Find(attribute);
  if (text != nullptr) return text;
  for (const XmlElement* element : DefaultsOf(placed)) {
    if (const std::string* said = element->Find(attribute)) text = said;
  }
  return text;
}

std::string PlacedElements::Get(const Placed& placed, std::string_view attribute,
                                std::string_view usual) const {
  const std::string* text = Find(placed, attribute);
  return text == nullptr ? std::string(usual) : *text;
}

std::string PlacedElements::Setting(std::string_view attribute, std::string_view usual) const {
  std::string value(usual);
  for (const Placed& placed : placed_) {
    if (placed.section != "compiler") continue;
    if (const std::string* said = placed.element->Find(attribute)) value = *said;
  }
  return value;
}

std::vector<double> NumbersOf(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos) return numbers;
    text.remove_prefix(start);
    const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
    const std::string_view word = text.substr(text.front() == '+' ? 1 : 0, end);
    double number = 0;
    const auto result = std::from_chars(word.data(), text.data() + end, number);
    if (result.ec != std::errc() || result.ptr != text.data() + end) return {};
    numbers.push_back(number);
    text.remove_prefix(end);
  }
}

std::string TextOf(const std::vector<double>& numbers) {
  return fmt::format("{}", fmt::join(numbers, " "));
}

}  // namespace mjforge::engine
