// Lookup of the names in `place:`, and findings about names that do not exist.

#include "mjforge/assemble/place_names.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mjforge/assemble/names.h"
#include "mjforge/assemble/regions.h"

namespace mjforge::assemble {
namespace {

using diag::Code;

// Largest number of names that a hint lists.
constexpr std::size_t kMostListed = 8;

constexpr const char* kLeftOutHint = "its `if` or `for` leaves it out in this variant";

bool HasName(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

// Returns the region and the site of body `body` whose full names are in `names`; nullopt if there
// is neither.
std::optional<PlaceTarget> FindOn(const model::Object& object, int body,
                                  const std::vector<std::string>& names) {
  const model::Body& owner = object.bodies[static_cast<std::size_t>(body)];
  PlaceTarget target{.body = body};
  target.region = diag::FindIf(
      owner.regions, [&](const model::Region& region) { return HasName(names, region.site); });
  target.site =
      diag::FindIf(owner.sites, [&](const model::Site& site) { return HasName(names, site.name); });
  if (target.region == nullptr && target.site == nullptr) return std::nullopt;
  return target;
}

// Returns the beginning of a name that contains an expression ("slot_" of "slot_${i}"); empty for a
// literal name.
std::string_view StemOf(const spec::Entry& entry) {
  const auto* text = std::get_if<spec::Text>(&entry.name.form);
  if (text == nullptr || spec::LiteralText(entry.name)) return {};
  return text->pieces.front().literal;
}

// Returns the first entry that has this literal name, or whose name contains an expression and
// begins like this name. Returns null if there is none.
const spec::Entry* FindElement(const std::vector<spec::Entry>& entries, std::string_view name) {
  return diag::FindIf(entries, [&](const spec::Entry& entry) {
    const std::string_view stem = StemOf(entry);
    return spec::LiteralText(entry.name) == name || (!stem.empty() && name.starts_with(stem));
  });
}

const spec::Entry* FindElement(const std::vector<spec::Entry>& regions,
                               const std::vector<spec::Entry>& sites, std::string_view name) {
  const spec::Entry* region = FindElement(regions, name);
  return region != nullptr ? region : FindElement(sites, name);
}

// Finds the body whose entry has the position `body` in the text of the spec or of a nested spec.
// Returns the entry of this body's region or site with this name; null if there is none.
const spec::Entry* FindDeclared(const spec::ObjectSpec& spec, diag::SourceMark body,
                                std::string_view name) {
  for (const spec::BodyEntry& entry : spec.bodies) {
    const spec::ObjectSpec* nested = entry.head.nested.get();
    const spec::Entry* found = nullptr;
    if (entry.head.mark == body) {
      found = FindElement(entry.regions, entry.sites, name);
      if (found == nullptr && nested != nullptr)
        found = FindElement(nested->regions, nested->sites, name);
    } else if (nested != nullptr) {
      found = FindDeclared(*nested, body, name);
    }
    if (found != nullptr) return found;
  }
  return nullptr;
}

bool MayBeLeftOut(const spec::Entry& entry) { return entry.condition || !entry.loops.empty(); }

bool IsSearched(const spec::Entry& region) {
  const spec::Field* type = region.Find(spec::Key::kType);
  return type != nullptr && spec::LiteralText(type->value) == "auto";
}

// Returns the full name without the first of the prefixes that matches.
std::string_view Without(std::string_view full, std::initializer_list<std::string_view> prefixes) {
  for (const std::string_view prefix : prefixes) {
    if (full.starts_with(prefix)) return full.substr(prefix.size());
  }
  return full;
}

}  // namespace

std::vector<std::string_view> PlaceNames::PathOf(std::string_view name) const {
  std::vector<std::string_view> path;
  for (std::size_t dot = name.find('.'); dot != std::string_view::npos; dot = name.find('.')) {
    path.push_back(name.substr(0, dot));
    name.remove_prefix(dot + 1);
  }
  path.push_back(name);
  if (path.size() > 1 && path.front() == scope_.values.spec().name) path.erase(path.begin());
  return path;
}

std::string PlaceNames::FullName(std::string_view body) const {
  return scope_.prefix + fmt::format("{}", fmt::join(PathOf(body), "_"));
}

std::string PlaceNames::OutermostName(std::string_view name) const {
  if (scope_.outer == nullptr) return std::string(name);
  std::string full = fmt::format("{}", fmt::join(PathOf(name), "."));
  for (const Scope* scope = &scope_; scope->outer != nullptr; scope = scope->outer) {
    const std::string prefix = scope->outer_prefix();
    const std::size_t outer = scope->outer->prefix.size();
    if (prefix.size() > outer + 1)
      full.insert(0, fmt::format("{}.", prefix.substr(outer, prefix.size() - outer - 1)));
  }
  return full;
}

std::optional<int> PlaceNames::FindBody(std::string_view name) const {
  if (name == scope_.values.spec().name) return scope_.body;
  const auto found = bodies_.find(FullName(name));
  return found == bodies_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<PlaceTarget> PlaceNames::Find(std::string_view name) const {
  std::vector<std::string_view> path = PathOf(name);
  const std::string last(path.back());
  path.pop_back();
  // Collects the possible full names of an element of the body BODY.INNER. The element's entry may
  // be in this spec, in the spec of BODY or in the spec of INNER, and each of these specs has
  // another prefix.
  std::string prefix = scope_.prefix;
  std::vector<std::string> names = {prefix + last};
  for (const std::string_view part : path) {
    prefix += fmt::format("{}_", part);
    names.push_back(prefix + last);
  }
  std::optional<int> body = scope_.body;
  if (!path.empty()) body = FindBody(fmt::format("{}", fmt::join(path, ".")));
  if (body) {
    if (auto target = FindOn(object_, *body, names)) return target;
  }
  // Searches all bodies, because elements of a welded spec (`parts:`) belong to the body of the
  // outer spec.
  for (int i = 0; i < static_cast<int>(object_.bodies.size()); ++i) {
    if (auto target = FindOn(object_, i, {names.back()})) return target;
  }
  return std::nullopt;
}

std::string PlaceNames::NameOf(int body) const {
  if (body == scope_.body) return scope_.values.spec().name;
  const std::string& full = object_.bodies[static_cast<std::size_t>(body)].name;
  return std::string(Without(full, {scope_.prefix}));
}

void PlaceNames::ReportBody(std::string_view owner, std::string_view name, diag::SourceMark mark,
                            diag::Findings& findings) const {
  if (std::ranges::find(object_.left_out, FullName(name)) != object_.left_out.end()) {
    findings.Add(Code::kModelUnknownReference, mark,
                 fmt::format("place of {}: body {} was left out, because there was no room for it",
                             owner, Quoted(name)),
                 "`fewer: true` leaves out this one, too");
    return;
  }
  diag::Finding& finding =
      findings.Add(Code::kModelUnknownReference, mark,
                   fmt::format("place of {}: no body {}", owner, Quoted(name)));
  const spec::BodyEntry* entry =
      diag::FindIf(scope_.values.spec().bodies, [&](const spec::BodyEntry& body) {
        return MayBeLeftOut(body.head) && spec::LiteralText(body.head.name) == name;
      });
  if (entry != nullptr) {
    finding.hint = kLeftOutHint;
    finding.notes.push_back({entry->head.mark, fmt::format("{} is here", Quoted(name))});
    return;
  }
  std::vector<std::string> names = {scope_.values.spec().name};
  for (const auto& [full, index] : bodies_) {
    if (full.starts_with(scope_.prefix) && index != scope_.body) names.push_back(NameOf(index));
  }
  std::ranges::sort(names);
  finding.hint = diag::DidYouMean(name, names);
}

std::vector<std::string_view> PlaceNames::TargetsOn(int index) const {
  const model::Body& body = object_.bodies[static_cast<std::size_t>(index)];
  auto names = diag::Mapped<std::string_view>(body.regions, &model::Region::name);
  for (const model::Site& site : body.sites)
    names.push_back(Without(site.name, {body.name + "_", scope_.prefix}));
  std::ranges::sort(names);
  // Each region also has a site of this name.
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

const spec::Entry* PlaceNames::FindEntry(int body, std::string_view name) const {
  const spec::ObjectSpec& spec = scope_.values.spec();
  return body == scope_.body
             ? FindElement(spec.regions, spec.sites, name)
             : FindDeclared(spec, object_.bodies[static_cast<std::size_t>(body)].mark, name);
}

void PlaceNames::ExplainAbsence(const spec::Entry& entry, int body, std::string_view name,
                                diag::Finding& finding) const {
  const std::string_view stem = StemOf(entry);
  const auto is_other = [&](std::string_view other) { return other.starts_with(stem); };
  if (!stem.empty() && std::ranges::any_of(TargetsOn(body), is_other)) return;
  const double tilt = model::TiltOf(model::BodyPoses(object_)[static_cast<std::size_t>(body)]);
  if (!IsSearched(entry))
    finding.hint = kLeftOutHint;
  else if (tilt > kLevelAngle)
    finding.hint =
        fmt::format("no level face was found: {} is {}", Quoted(NameOf(body)), TiltText(tilt));
  else
    finding.hint =
        "no level face was found: `area`, `height` or `margin` is too large, or nothing collides";
  finding.notes.push_back({entry.mark, fmt::format("{} is here", Quoted(name))});
}

void PlaceNames::ReportTarget(std::string_view owner, std::string_view name, diag::SourceMark mark,
                              diag::Findings& findings, std::string_view remedy) const {
  const std::size_t dot = name.rfind('.');
  const bool is_root = dot == std::string_view::npos;
  const std::string body_name(is_root ? scope_.values.spec().name : name.substr(0, dot));
  const std::optional<int> index = FindBody(body_name);
  if (!index) return ReportBody(owner, body_name, mark, findings);
  const std::string_view last = is_root ? name : name.substr(dot + 1);
  if (const std::optional<int> other = FindBody(name)) {
    const std::vector<std::string_view> places = TargetsOn(*other);
    findings.Add(
        Code::kModelUnknownReference, mark,
        fmt::format("place of {}: {} is a body, not a region or a site", owner, Quoted(name)),
        places.empty() ? "give it one with `regions:`"
                       : fmt::format("such as {}.{}", name, places.front()));
    return;
  }
  const spec::Entry* entry = FindEntry(*index, last);
  const bool may_be_absent = entry != nullptr && (IsSearched(*entry) || MayBeLeftOut(*entry));
  const bool may_be_wrong = entry != nullptr && (!may_be_absent || IsSearched(*entry));
  if (may_be_wrong && findings.HasErrors()) return;  // the entry, or what it searches, is wrong
  std::vector<std::string_view> names = TargetsOn(*index);
  std::string hint = diag::DidYouMean(last, std::span<const std::string_view>(names));
  if (names.empty()) {
    hint = fmt::format("give it one with `{}:`", remedy);
  } else if (hint.empty()) {
    names.resize(std::min(names.size(), kMostListed));
    hint = fmt::format("it has {}", fmt::join(names, ", "));
  }
  diag::Finding& finding =
      findings.Add(Code::kModelUnknownReference, mark,
                   fmt::format("place of {}: body {} has no region and no site {}", owner,
                               Quoted(body_name), Quoted(last)),
                   std::move(hint));
  if (may_be_absent) ExplainAbsence(*entry, *index, last, finding);
}

}  // namespace mjforge::assemble
