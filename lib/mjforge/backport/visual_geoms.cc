// Removes visual geoms to which nothing refers, as the compiler setting `discardvisual` does in
// later MuJoCo releases.
#include "mjforge/backport/visual_geoms.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/engine/engine.h"

namespace mjforge::backport {
namespace {

/// Adds to `names` the names of the geoms to which the elements of a section refer.
void AddReferences(const xml::XmlElement& section, std::set<std::string>& names) {
  const auto add = [&](const xml::XmlElement& element, std::string_view attribute) {
    if (const std::string* name = element.Find(attribute)) names.insert(*name);
  };
  const auto is_geom = [](const xml::XmlElement& element, std::string_view type) {
    const std::string* word = element.Find(type);
    return word != nullptr && *word == "geom";
  };
  for (const xml::XmlElement& child : section.children) {
    for (const std::string_view attribute : {"geom", "geom1", "geom2"}) add(child, attribute);
    if (is_geom(child, "objtype")) add(child, "objname");
    if (is_geom(child, "reftype")) add(child, "refname");
    AddReferences(child, names);
  }
}

std::set<std::string> ReferencedGeoms(const xml::XmlElement& root) {
  constexpr std::string_view kSections[] = {"contact", "tendon", "sensor", "custom"};
  std::set<std::string> names;
  for (const xml::XmlElement& section : root.children) {
    if (std::ranges::find(kSections, section.tag) != std::end(kSections))
      AddReferences(section, names);
  }
  return names;
}

void Erase(xml::XmlElement& parent, const std::set<const xml::XmlElement*>& erased) {
  for (xml::XmlElement& child : parent.children) Erase(child, erased);
  std::erase_if(parent.children,
                [&](const xml::XmlElement& child) { return erased.contains(&child); });
}

}  // namespace

bool IsZero(const std::string& text) {
  return text.find_first_not_of("+-0. \t\r\n") == std::string::npos;
}

bool IsVisual(const DefaultClasses& elements, const ClassedElement& geom) {
  return IsZero(elements.Get(geom, "contype", "1")) &&
         IsZero(elements.Get(geom, "conaffinity", "1"));
}

diag::SourceMark KeepReferencedGeoms(xml::XmlElement& root) {
  if (mjVERSION_HEADER >= 312) return {};
  DefaultClasses elements(root);
  if (elements.Setting("discardvisual", "false") != "true") return {};
  const std::set<std::string> referenced = ReferencedGeoms(root);
  std::set<const xml::XmlElement*> erased;
  diag::SourceMark first;
  for (const ClassedElement* geom : elements.In("geom")) {
    const std::string& parent = geom->parent->tag;
    if ((parent != "body" && parent != "worldbody") || !IsVisual(elements, *geom)) continue;
    if (!referenced.contains(geom->element->Name())) {
      erased.insert(geom->element);
    } else if (!first) {
      first = geom->element->mark;
    }
  }
  if (!first) return {};
  for (const ClassedElement* compiler : elements.In("compiler"))
    compiler->element->Set("discardvisual", "false");
  Erase(root, erased);
  return first;
}

}  // namespace mjforge::backport
