#include "mjforge/model/names.h"

#include <algorithm>
#include <map>
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

// The names of one kind with the places of their elements; repeats are
// reported, one for each place.
class Kind {
 public:
  Kind(std::string_view kind, diag::Findings& findings) : kind_(kind), findings_(findings) {}
  void Expect(std::size_t count) { by_name_.reserve(count); }

  void Add(std::string_view name, diag::SourceMark mark, const Part* part = nullptr) {
    if (name.empty()) return;
    const auto [found, is_new] = by_name_.try_emplace(name, Place{mark, part});
    if (is_new || (reported_ && reported_ == mark)) return;
    reported_ = mark;
    ReportTwice(kind_, std::string(name), mark, found->second.mark, {}, findings_);
  }
  template <typename Elements>
  void AddAll(const Elements& elements) {
    for (const auto& element : elements) Add(element.name, element.mark);
  }

  struct Place {
    diag::SourceMark mark;
    const Part* part;
  };
  const Place* Find(std::string_view name) const {
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? nullptr : &found->second;
  }

 private:
  std::string_view kind_;
  diag::Findings& findings_;
  std::unordered_map<std::string_view, Place> by_name_;
  diag::SourceMark reported_;
};

// A part whose name is that of another part's visual twin.
void CheckTwins(const Object& object, const Kind& parts, diag::Findings& findings) {
  for (const Body& body : object.bodies) {
    for (const Part& part : body.parts) {
      if (!part.name.ends_with(kTwin)) continue;
      std::string_view stem = part.name;
      stem.remove_suffix(kTwin.size());
      const Kind::Place* twin = parts.Find(stem);
      if (twin == nullptr || twin->part->role == Role::kCollision || twin->part->as_is) continue;
      // A visual part has no geom of its own name.
      if (!part.as_is && part.role == Role::kVisual) continue;
      ReportTwice("part", part.name, part.mark, twin->mark,
                  fmt::format("part '{}' has a visual twin of that name", stem), findings);
    }
  }
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
  Kind materials("material", findings);
  Kind textures("texture", findings);
  Kind meshes("mesh", findings);
  Kind bodies("body", findings);
  Kind joints("joint", findings);
  Kind sites("site", findings);
  Kind parts("part", findings);
  bodies.Expect(object.bodies.size());
  joints.Expect(object.bodies.size());
  std::size_t part_count = 0;
  for (const Body& body : object.bodies) part_count += body.parts.size();
  parts.Expect(part_count);
  materials.AddAll(object.materials);
  textures.AddAll(object.textures);
  for (const auto& mesh : object.meshes) meshes.Add(mesh->name, mesh->mark);
  bodies.AddAll(object.bodies);
  std::map<std::string_view, Kind> others;  // cameras, lights
  for (const Body& body : object.bodies) {
    joints.AddAll(body.joints);
    sites.AddAll(body.sites);
    for (const Part& part : body.parts) parts.Add(part.name, part.mark, &part);
    for (const Element& element : body.elements) {
      others.try_emplace(element.tag, element.tag, findings)
          .first->second.Add(element.name, element.mark);
    }
  }
  CheckTwins(object, parts, findings);
  for (const Section& section : object.sections) {
    if (section.info->is_element) continue;
    Kind elements(section.info->name, findings);
    elements.AddAll(section.elements);
  }
}

}  // namespace mjforge::model
