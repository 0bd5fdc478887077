#include "mjforge/model/names.h"

#include <algorithm>
#include <unordered_map>

#include <fmt/format.h>

namespace mjforge::model {
namespace {

constexpr std::string_view kTwin = "_vis";

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool IsNamePart(char c) { return IsLetter(c) || (c >= '0' && c <= '9') || c == '_'; }

void ReportTwice(std::string_view kind, const std::string& name, diag::SourceMark second,
                 diag::SourceMark first, std::string hint, diag::Findings& findings) {
  const bool same_entry = second == first;
  if (same_entry && hint.empty()) hint = "put the variable of 'for' into the name, as in wall_${i}";
  diag::Finding& finding =
      findings.Add(diag::Code::kModelDuplicateName, second,
                   fmt::format("two {}s are named '{}'", kind, name), std::move(hint));
  if (!same_entry) finding.notes.push_back({first, "the other one"});
}

// The elements by name; repeats are reported, one for each place.
template <typename Element>
std::unordered_map<std::string_view, const Element*> Check(std::string_view kind,
                                                           const std::vector<Element>& elements,
                                                           diag::Findings& findings) {
  std::unordered_map<std::string_view, const Element*> by_name;
  by_name.reserve(elements.size());
  diag::SourceMark reported;
  for (const Element& element : elements) {
    const auto [found, is_new] = by_name.try_emplace(element.name, &element);
    if (is_new || (reported && reported == element.mark)) continue;
    reported = element.mark;
    ReportTwice(kind, element.name, element.mark, found->second->mark, {}, findings);
  }
  return by_name;
}

}  // namespace

bool IsName(std::string_view text) {
  return !text.empty() && IsLetter(text.front()) && std::ranges::all_of(text, IsNamePart);
}

std::string Quoted(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  std::string out = "'";
  for (const char c : text.substr(0, kLongest)) {
    if (c == '\n') {
      out += "\\n";
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      out += c;
    }
  }
  return out + (text.size() > kLongest ? "...'" : "'");
}

void CheckUniqueNames(const Object& object, diag::Findings& findings) {
  Check("material", object.materials, findings);
  for (const Body& body : object.bodies) {
    Check("site", body.sites, findings);
    Check("joint", body.joints, findings);
    const auto parts = Check("part", body.parts, findings);
    for (const Part& part : body.parts) {
      if (!part.name.ends_with(kTwin)) continue;
      std::string_view stem = part.name;
      stem.remove_suffix(kTwin.size());
      const auto twin = parts.find(stem);
      if (twin == parts.end() || twin->second->role != Role::kBoth) continue;
      ReportTwice("part", part.name, part.mark, twin->second->mark,
                  fmt::format("part '{}' has a visual twin of that name", stem), findings);
    }
  }
}

}  // namespace mjforge::model
