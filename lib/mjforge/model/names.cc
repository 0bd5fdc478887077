#include "mjforge/model/names.h"

#include <map>
#include <unordered_map>

#include <fmt/format.h>

namespace mjforge::model {
namespace {

constexpr std::string_view kTwin = "_vis";

void ReportTwice(std::string_view kind, const std::string& name, diag::SourceMark second,
                 diag::SourceMark first, std::string hint, diag::Findings& findings) {
  const bool same_entry = second == first;
  if (same_entry && hint.empty()) hint = "put the variable of 'for' into the name, as in wall_${i}";
  diag::Finding& finding =
      findings.Add(diag::Code::kModelDuplicateName, second,
                   fmt::format("two {}s are named '{}'", kind, name), std::move(hint));
  if (!same_entry) finding.notes.push_back({first, "the other one"});
}

// The named elements of an object by kind and name.
class NameTable {
 public:
  struct Place {
    std::string_view kind;
    std::string_view name;
    diag::SourceMark mark;
    const Part* part = nullptr;
  };

  explicit NameTable(diag::Findings& findings) : findings_(findings) {}

  /// Repeats are reported, one for each place in the spec.
  void Add(const Place& place) {
    if (place.name.empty()) return;
    const auto [known, is_new] = places_[place.kind].try_emplace(place.name, place);
    if (is_new) return;
    diag::SourceMark& reported = reported_[place.kind];
    if (reported && reported == place.mark) return;
    reported = place.mark;
    ReportTwice(place.kind, std::string(place.name), place.mark, known->second.mark, {}, findings_);
  }
  template <typename Elements>
  void AddAll(std::string_view kind, const Elements& elements) {
    for (const auto& element : elements) Add({kind, element.name, element.mark});
  }
  const Place* Find(std::string_view kind, std::string_view name) const {
    const auto& places = places_.find(kind)->second;
    const auto found = places.find(name);
    return found == places.end() ? nullptr : &found->second;
  }

 private:
  diag::Findings& findings_;
  std::map<std::string_view, std::unordered_map<std::string_view, Place>> places_;
  std::map<std::string_view, diag::SourceMark> reported_;  // the last one of a kind
};

// A part whose name is that of another part's visual twin.
void CheckTwins(const Object& object, const NameTable& names, diag::Findings& findings) {
  for (const Body& body : object.bodies) {
    for (const Part& part : body.parts) {
      if (!part.name.ends_with(kTwin)) continue;
      std::string_view stem = part.name;
      stem.remove_suffix(kTwin.size());
      const NameTable::Place* twin = names.Find("part", stem);
      if (twin == nullptr || twin->part->role == Role::kCollision || twin->part->as_is) continue;
      // A visual part has no geom of its own name.
      if (!part.as_is && part.role == Role::kVisual) continue;
      ReportTwice("part", part.name, part.mark, twin->mark,
                  fmt::format("part '{}' has a visual twin of that name", stem), findings);
    }
  }
}

}  // namespace

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
  NameTable names(findings);
  names.AddAll("material", object.materials);
  names.AddAll("texture", object.textures);
  for (const auto& mesh : object.meshes) names.Add({"mesh", mesh->name, mesh->mark});
  names.AddAll("body", object.bodies);
  for (const Body& body : object.bodies) {
    names.AddAll("joint", body.joints);
    names.AddAll("site", body.sites);
    for (const Part& part : body.parts) names.Add({"part", part.name, part.mark, &part});
    // Cameras and lights.
    for (const Element& element : body.elements) {
      names.Add({element.tag, element.name, element.mark});
    }
  }
  CheckTwins(object, names, findings);
  for (const Section& section : object.sections) {
    if (!section.info->is_element) names.AddAll(section.info->name, section.elements);
  }
}

}  // namespace mjforge::model
