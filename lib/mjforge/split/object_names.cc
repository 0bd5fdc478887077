// Renaming of the elements of an object that is copied from a scene, and of references to them;
// check for duplicate names.

#include "mjforge/split/object_names.h"

#include <algorithm>

#include <fmt/format.h>

namespace mjforge::split {
namespace {

// Returns true if the name begins with the object's name and an underscore.
bool HasPrefixOf(std::string_view object, std::string_view name) {
  return name.size() > object.size() + 1 && name.starts_with(object) && name[object.size()] == '_';
}

}  // namespace

std::string ObjectNames::Of(std::string_view kind, const std::string& name) const {
  if (name.empty()) return name;
  if (kind.ends_with("body") && name == own_) return root_;
  std::string stem = HasPrefixOf(own_, name) ? name.substr(own_.size() + 1) : name;
  // Puts an underscore before names such as `glass_0` and `glass_0_rim` in the file of `glass_0`.
  // The host that loads the file adds the prefix `glass_0_` to all names except those that seem to
  // have this prefix already.
  const bool looks_prefixed = prefix_.empty() && (stem == own_ || HasPrefixOf(own_, stem));
  return (looks_prefixed ? "_" : prefix_) + stem;
}

std::string ObjectNames::OfAsset(std::string_view kind, const std::string& name) {
  const auto [found, is_new] = assets_.try_emplace({std::string(kind), name});
  if (!is_new) return found->second;
  std::size_t longest = 0;
  for (const std::string& object : objects_) {
    if (HasPrefixOf(object, name)) longest = std::max(longest, object.size() + 1);
  }
  const std::string stem = prefix_ + name.substr(longest);
  std::string unique = stem;
  for (int i = 2; !taken_.emplace(std::string(kind), unique).second; ++i)
    unique = fmt::format("{}_{}", stem, i);
  found->second = unique;
  return unique;
}

void ObjectNames::Rename(model::Element& element) const {
  element.name = Of(element.tag, element.name);
  for (model::Attribute& attribute : element.attributes) {
    if (attribute.refers.empty()) continue;
    const std::string_view kind = model::KindOf(attribute, element);
    const auto asset = assets_.find({std::string(kind), attribute.text});
    attribute.text = asset != assets_.end() ? asset->second : Of(kind, attribute.text);
  }
  for (model::Element& child : element.children) Rename(child);
}

void ObjectNames::Rename(model::Body& body) const {
  body.name = Of("body", body.name);
  for (model::Joint& joint : body.joints) joint.name = Of("joint", joint.name);
  for (model::Site& site : body.sites) site.name = Of("site", site.name);
  for (model::Region& region : body.regions) region.site = Of("site", region.site);
  for (model::Element& view : body.elements) Rename(view);
  for (model::Part& part : body.parts) {
    part.name = Of("geom", part.name);
    part.piece_of = Of("geom", part.piece_of);
  }
}

bool HasUniqueNames(const model::Object& object, diag::Findings& findings) {
  std::set<std::pair<std::string_view, std::string_view>> names;
  bool is_good = true;
  const auto add = [&](std::string_view kind, std::string_view name, diag::SourceMark mark) {
    if (names.emplace(kind, name).second) return;
    is_good = false;
    findings.Add(
        diag::Code::kModelDuplicateName, mark,
        fmt::format("two {}s of '{}' are named '{}' in its own file", kind, object.name, name),
        "rename the one that begins with the name of the object");
  };
  for (const model::Body& body : object.bodies) {
    add("body", body.name, body.mark);
    for (const model::Joint& joint : body.joints) add("joint", joint.name, joint.mark);
    for (const model::Site& site : body.sites) add("site", site.name, site.mark);
    // Previous part. A part that was divided into a collision part and a visual part may have the
    // same name twice.
    const model::Part* last = nullptr;
    for (const model::Part& part : body.parts) {
      const bool is_twin = last != nullptr && part.name == last->name && part.mark == last->mark;
      if (!is_twin) add("part", part.name, part.mark);
      last = &part;
    }
  }
  return is_good;
}

}  // namespace mjforge::split
