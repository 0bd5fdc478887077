// Compares the names to which a sensor refers with the names of the elements in a file.
#include "mjforge/backport/sensor_references.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/backport/default_classes.h"
#include "mjforge/backport/mjcf_versions.h"

namespace mjforge::backport {
namespace {

/// Attributes of sensors that name another element, each with the kind of that element. "@objtype"
/// means that the kind is the value of the attribute `objtype`.
constexpr std::pair<std::string_view, std::string_view> kReferences[] = {
    {"site", "site"},     {"joint", "joint"},      {"tendon", "tendon"},   {"actuator", "actuator"},
    {"camera", "camera"}, {"mesh", "mesh"},        {"geom", "geom"},       {"geom1", "geom"},
    {"geom2", "geom"},    {"body1", "body"},       {"body2", "body"},      {"subtree1", "body"},
    {"subtree2", "body"}, {"objname", "@objtype"}, {"refname", "@reftype"}};

using Names = std::set<std::string>;

/// Adds the names of all elements of a kind to `names`; returns false if the tree has an element
/// that MuJoCo expands to elements with new names (replicate, composite, ...).
bool AddNames(const xml::XmlElement& parent, std::string_view kind, Names& names) {
  constexpr std::string_view kExpanded[] = {"replicate", "attach", "composite", "flexcomp"};
  for (const xml::XmlElement& child : parent.children) {
    if (child.tag == "default") continue;
    if (std::ranges::find(kExpanded, child.tag) != std::end(kExpanded)) return false;
    std::string_view element_kind = ElementKindOf(parent.tag, child.tag);
    if (element_kind == "freejoint") element_kind = "joint";
    if (element_kind == kind) names.insert(child.AssetName());
    if (!AddNames(child, kind, names)) return false;
  }
  return true;
}

}  // namespace

void CheckReferences(const xml::XmlElement& sensor, const xml::XmlElement& root,
                     const diag::Sources& sources, diag::Findings& findings) {
  for (const auto& [attribute, word] : kReferences) {
    const std::string* name = sensor.Find(attribute);
    if (name == nullptr) continue;
    std::string_view kind = word;
    if (kind.starts_with('@')) {
      const std::string* type = sensor.Find(kind.substr(1));
      if (type == nullptr) continue;  // MuJoCo reports the missing attribute
      kind = *type == "xbody" ? "body" : std::string_view(*type);
    }
    Names names;
    if (kind == "body") names.insert("world");
    if (!AddNames(root, kind, names)) return;
    if (names.contains(*name)) continue;
    findings.Add(diag::Code::kMujocoError, xml::MarkOfAttribute(sources, sensor, attribute),
                 fmt::format("'{}' of {} is '{}', but the file has no {} of that name", attribute,
                             sensor.Description(), *name, kind),
                 diag::DidYouMean(*name, names));
  }
}

}  // namespace mjforge::backport
