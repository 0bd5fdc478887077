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

void References::Add(Place place, std::string_view kind, std::string full_name, std::string shown,
                     std::string owner, diag::SourceMark mark) {
  references_.push_back(
      {place, Canonical(kind), std::move(full_name), std::move(shown), std::move(owner), mark});
}

void References::TakeAway(std::string joint, std::string origin) {
  gone_["joint"].emplace(std::move(joint), fmt::format("attaching {} takes it away", origin));
}

References::Names References::Collect() const {
  Names names;
  for (const Body& body : object_.bodies) {
    names["body"].insert(body.name);
    for (const Joint& joint : body.joints) names["joint"].insert(joint.name);
    for (const Site& site : body.sites) names["site"].insert(site.name);
    for (const Element& element : body.elements) names[element.tag].insert(element.name);
  }
  for (const Material& material : object_.materials) names["material"].insert(material.name);
  for (const auto& mesh : object_.meshes) names["mesh"].insert(mesh->name);
  for (const Section& section : object_.sections) {
    for (std::size_t i = 0; i < section.elements.size(); ++i) {
      if (taken_out_.contains({section.info, i})) continue;
      names[section.info->name].insert(section.elements[i].name);
    }
  }
  return names;
}

void References::Check() {
  if (references_.empty()) return;
  // Taking one element out may leave another without what it refers to.
  while (std::ranges::any_of(references_, [this](const Reference& r) { return TakeOutOne(r); })) {
  }
  const Names names = Collect();
  std::set<std::string> geoms;
  for (const Body& body : object_.bodies) {
    for (const Part& part : body.parts) {
      if (part.as_is || part.role != Role::kVisual) geoms.insert(part.name);
      if (!part.as_is && part.role != Role::kCollision) geoms.insert(part.name + "_vis");
    }
  }
  const std::set<std::string_view> geom_names(geoms.begin(), geoms.end());
  for (const Reference& reference : references_) {
    if (taken_out_.contains({reference.place.section, reference.place.position})) continue;
    const auto kind = names.find(reference.kind);
    const std::set<std::string_view> none;
    const auto& known = reference.kind == "geom" ? geom_names
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
                                            fmt::format("it is left out since {}", gone->second));
  diag::Finding& finding =
      findings_.Add(Code::kAttachNotCarried, reference.mark,
                    fmt::format("{} '{}' is left out: its {} '{}' is gone, {}", element.tag,
                                element.name, reference.kind, reference.shown, gone->second));
  finding.severity = diag::Severity::kWarning;
  return true;
}

void References::Report(const Reference& reference, const std::set<std::string_view>& names) {
  // Suggestions as the spec would say them, without the prefix.
  const std::size_t prefix = reference.name.size() >= reference.shown.size()
                                 ? reference.name.size() - reference.shown.size()
                                 : 0;
  const std::string_view start = std::string_view(reference.name).substr(0, prefix);
  std::vector<std::string_view> own;
  for (const std::string_view name : names) {
    if (name.starts_with(start)) own.push_back(name.substr(prefix));
  }
  findings_.Add(Code::kModelUnknownReference, reference.mark,
                fmt::format("{} is {}, but the object has no {} of that name", reference.owner,
                            Quoted(reference.shown), reference.kind),
                diag::DidYouMean(reference.shown, own));
}

}  // namespace mjforge::model
