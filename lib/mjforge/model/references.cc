#include "mjforge/model/references.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "mjforge/model/names.h"

namespace mjforge::model {
namespace {

using diag::Code;

// MJCF says `xbody` for a body's frame where `body` is its inertial one.
std::string_view Canonical(std::string_view kind) { return kind == "xbody" ? "body" : kind; }

}  // namespace

std::string_view KindOf(const Attribute& attribute, const Element& element) {
  if (!attribute.refers.starts_with('@')) return attribute.refers;
  const auto said =
      std::ranges::find(element.attributes, attribute.refers.substr(1), &Attribute::name);
  return said == element.attributes.end() ? attribute.refers : std::string_view(said->text);
}

void References::Add(Place place, std::string_view kind, std::string full_name, std::string shown,
                     std::string owner, diag::SourceMark mark) {
  references_.push_back(
      {place, Canonical(kind), std::move(full_name), std::move(shown), std::move(owner), mark});
}

void References::TakeAway(std::string joint, std::string origin) {
  gone_["joint"].emplace(std::move(joint), fmt::format("attaching {} removes it", origin));
}

// Of the kinds that something refers to.
References::Names References::Collect() const {
  Names names;
  for (const Reference& reference : references_) names.try_emplace(reference.kind);
  const auto add = [&names](std::string_view kind, std::string_view name) {
    const auto wanted = names.find(kind);
    if (wanted != names.end()) wanted->second.insert(name);
  };
  for (const Body& body : object_.bodies) {
    add("body", body.name);
    for (const Joint& joint : body.joints) add("joint", joint.name);
    for (const Site& site : body.sites) add("site", site.name);
    for (const Element& element : body.elements) add(element.tag, element.name);
  }
  for (const Material& material : object_.materials) add("material", material.name);
  for (const auto& mesh : object_.meshes) add("mesh", mesh->name);
  for (const Section& section : object_.sections) {
    for (std::size_t i = 0; i < section.elements.size(); ++i) {
      if (taken_out_.contains({section.info, i})) continue;
      add(section.info->name, section.elements[i].name);
    }
  }
  return names;
}

bool References::IsTakenAway(const std::string& joint) const {
  const auto joints = gone_.find("joint");
  return joints != gone_.end() && joints->second.contains(joint);
}

void References::Check() {
  if (references_.empty()) return;
  // Taking one element out may leave another without what it refers to.
  for (bool changed = true; changed;) {
    changed = false;
    for (const Reference& reference : references_) changed |= TakeOutOne(reference);
  }
  const Names names = Collect();
  std::vector<std::string> geoms;
  for (const Body& body : object_.bodies) {
    if (!names.contains("geom")) break;
    for (const Part& part : body.parts) {
      if (part.as_is || part.role != Role::kVisual) geoms.push_back(part.name);
      if (!part.as_is && part.role != Role::kCollision) geoms.push_back(part.name + "_vis");
    }
  }
  const Set geom_names(geoms.begin(), geoms.end());
  for (const Reference& reference : references_) {
    if (taken_out_.contains({reference.place.section, reference.place.position})) continue;
    const auto kind = names.find(reference.kind);
    const Set none;
    const Set& known = reference.kind == "geom" ? geom_names
                       : kind == names.end()    ? none
                                                : kind->second;
    if (!known.contains(reference.name)) Report(reference, known);
  }
  for (Section& section : object_.sections) {
    std::size_t position = 0;
    std::erase_if(section.elements, [&](const Element&) {
      return taken_out_.contains({section.info, position++});
    });
  }
  std::erase_if(object_.sections, [](const Section& section) { return section.elements.empty(); });
}

bool References::TakeOutOne(const Reference& reference) {
  const auto kind = gone_.find(reference.kind);
  if (kind == gone_.end()) return false;
  const auto gone = kind->second.find(reference.name);
  if (gone == kind->second.end()) return false;
  const auto [section, position] = reference.place;
  if (!taken_out_.insert({section, position}).second) return false;
  const auto found = std::ranges::find(object_.sections, section, &Section::info);
  const Element& element = found->elements[position];
  gone_[std::string(section->name)].emplace(element.name,
                                            fmt::format("it is left out because {}", gone->second));
  diag::Finding& finding =
      findings_.Add(Code::kAttachNotCarried, reference.mark,
                    fmt::format("{} '{}' is left out: its {} '{}' is gone: {}", element.tag,
                                element.name, reference.kind, reference.shown, gone->second));
  finding.severity = diag::Severity::kWarning;
  return true;
}

void References::Report(const Reference& reference, const Set& names) {
  // Suggestions as the spec would say them, without the prefix.
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
                diag::DidYouMean(reference.shown, own));
}

}  // namespace mjforge::model
