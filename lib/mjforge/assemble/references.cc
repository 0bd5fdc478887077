// References between elements by name: removes elements that refer to removed elements, and reports
// references to elements that do not exist.

#include "mjforge/assemble/references.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"

namespace mjforge::assemble {
namespace {

using diag::Code;

// Returns "body" for "xbody". In MJCF, both kinds are bodies: "body" refers to the inertial frame,
// "xbody" to the body's own frame.
std::string_view Canonical(std::string_view kind) { return kind == "xbody" ? "body" : kind; }

}  // namespace

void References::Add(ElementPlace place, std::string_view kind, std::string full_name,
                     std::string shown, std::string owner, diag::SourceMark mark) {
  references_.push_back(
      {place, Canonical(kind), std::move(full_name), std::move(shown), std::move(owner), mark});
}

void References::MarkRemoved(std::string joint, std::string origin) {
  removed_["joint"].emplace(std::move(joint), fmt::format("attaching {} removes it", origin));
}

References::Names References::CollectNames(std::vector<std::string>& geoms) const {
  Names names;
  for (const NameReference& reference : references_) names.try_emplace(reference.kind);
  const auto add = [&names](std::string_view kind, std::string_view name) {
    const auto wanted = names.find(kind);
    if (wanted != names.end()) wanted->second.insert(name);
  };
  for (const model::Body& body : object_.bodies) {
    add("body", body.name);
    for (const model::Joint& joint : body.joints) add("joint", joint.name);
    for (const model::Site& site : body.sites) add("site", site.name);
    for (const model::Element& element : body.elements) add(element.tag, element.name);
  }
  for (const model::Material& material : object_.materials) add("material", material.name);
  for (const auto& mesh : object_.meshes) add("mesh", mesh->name);
  for (const model::Section& section : object_.sections) {
    for (std::size_t i = 0; i < section.elements.size(); ++i) {
      if (IsDropped({section.info, i})) continue;
      add(section.info->name, section.elements[i].name);
    }
  }
  const auto wanted = names.find("geom");
  if (wanted == names.end()) return names;
  for (const model::Body& body : object_.bodies) {
    for (const model::Part& part : body.parts) {
      if (part.as_is || part.role != model::Role::kVisual) geoms.push_back(part.name);
      if (!part.as_is && part.role != model::Role::kCollision)
        geoms.push_back(part.name + std::string(model::kVisualSuffix));
    }
  }
  wanted->second.insert(geoms.begin(), geoms.end());
  return names;
}

bool References::IsRemoved(const std::string& joint) const {
  const auto joints = removed_.find("joint");
  return joints != removed_.end() && joints->second.contains(joint);
}

void References::Check() {
  if (references_.empty()) return;
  // Repeats until nothing changes, because elements may refer to elements that were just removed.
  for (bool changed = true; changed;) {
    changed = false;
    for (const NameReference& reference : references_) changed |= DropIfRemoved(reference);
  }
  std::vector<std::string> geoms;
  const Names names = CollectNames(geoms);
  for (const NameReference& reference : references_) {
    if (IsDropped(reference.place)) continue;
    const Set& known = names.at(reference.kind);
    if (!known.contains(reference.name)) Report(reference, known);
  }
  for (model::Section& section : object_.sections) {
    std::size_t position = 0;
    std::erase_if(section.elements, [&](const model::Element&) {
      return IsDropped({section.info, position++});
    });
  }
  std::erase_if(object_.sections,
                [](const model::Section& section) { return section.elements.empty(); });
}

bool References::DropIfRemoved(const NameReference& reference) {
  const auto kind = removed_.find(reference.kind);
  if (kind == removed_.end()) return false;
  const auto removed = kind->second.find(reference.name);
  if (removed == kind->second.end()) return false;
  const auto [section, position] = reference.place;
  if (!dropped_.insert({section, position}).second) return false;
  const auto found = std::ranges::find(object_.sections, section, &model::Section::info);
  const model::Element& element = found->elements[position];
  removed_[std::string(section->name)].emplace(
      element.name, fmt::format("it is left out because {}", removed->second));
  findings_.Warn(Code::kAttachNotCarried, reference.mark,
                 fmt::format("{} '{}' is left out: its {} '{}' is gone: {}",
                             section->name == "equality" ? section->name : element.tag,
                             element.name, reference.kind, reference.shown, removed->second));
  return true;
}

void References::Report(const NameReference& reference, const Set& names) {
  // Suggests names as the spec writes them, without the prefix.
  const std::size_t prefix = reference.name.size() >= reference.shown.size()
                                 ? reference.name.size() - reference.shown.size()
                                 : 0;
  const std::string_view start = std::string_view(reference.name).substr(0, prefix);
  std::vector<std::string_view> own;
  for (const std::string_view name : names) {
    if (name.starts_with(start)) own.push_back(name.substr(prefix));
  }
  std::ranges::sort(own);
  findings_.Add(Code::kModelUnknownReference, reference.mark,
                fmt::format("{} is {}, but the object has no {} of that name", reference.owner,
                            Quoted(reference.shown), reference.kind),
                MissingNameHint(object_, reference.name, reference.shown, own));
}

}  // namespace mjforge::assemble
