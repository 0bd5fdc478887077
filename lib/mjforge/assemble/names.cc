// Quoting of texts, and the search for duplicate names of elements.

#include "mjforge/assemble/names.h"

#include <algorithm>
#include <functional>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace mjforge::assemble {
namespace {

// Entry of a NameTable: an element with a name.
struct NamedElement {
  std::size_t hash;
  std::string_view kind;
  std::string_view name;
  std::size_t position = 0;
  diag::SourceMark mark = {};
  const model::Part* part = nullptr;

  /// Compares the hashes of the names first, because comparing numbers is faster than comparing
  /// texts.
  bool operator<(const NamedElement& other) const {
    if (hash != other.hash) return hash < other.hash;
    return std::tie(kind, name, position) < std::tie(other.kind, other.name, other.position);
  }
};

// Named elements of an object, which can be found by kind and name.
class NameTable {
 public:
  /// Makes room for the elements of most objects.
  NameTable() { elements_.reserve(64); }

  void Add(std::string_view kind, std::string_view name, diag::SourceMark mark,
           const model::Part* part = nullptr) {
    if (name.empty()) return;
    elements_.push_back({HashOf(name), kind, name, elements_.size(), mark, part});
  }
  template <typename Elements>
  void AddAll(std::string_view kind, const Elements& elements) {
    for (const auto& element : elements) Add(kind, element.name, element.mark);
  }

  /// Sorts the table, and reports repeated names in the order in which they were added. Several
  /// repetitions at the same place in the spec are reported once.
  void ReportDuplicates(diag::Findings& findings) {
    std::sort(elements_.begin(), elements_.end());
    const NamedElement* first = nullptr;
    std::map<std::size_t, std::pair<const NamedElement*, const NamedElement*>> duplicates;
    for (const NamedElement& element : elements_) {
      if (first != nullptr && element.kind == first->kind && element.name == first->name) {
        duplicates.emplace(element.position, std::pair(&element, first));
      } else {
        first = &element;
      }
    }
    std::map<std::string_view, diag::SourceMark> reported;  // position of the last report, by kind
    for (const auto& [position, pair] : duplicates) {
      const auto& [element, earlier] = pair;
      diag::SourceMark& last = reported[element->kind];
      if (last && last == element->mark) continue;
      last = element->mark;
      ReportRepeatedName(element->kind, std::string(element->name), element->mark, earlier->mark,
                         {}, findings);
    }
  }

  /// Returns the first element of this kind and name; null if there is none. The table must be
  /// sorted.
  const NamedElement* Find(std::string_view kind, std::string_view name) const {
    const NamedElement wanted = {.hash = HashOf(name), .kind = kind, .name = name};
    const auto found = std::lower_bound(elements_.begin(), elements_.end(), wanted);
    const bool exists = found != elements_.end() && found->kind == kind && found->name == name;
    return exists ? &*found : nullptr;
  }

 private:
  static std::size_t HashOf(std::string_view name) { return std::hash<std::string_view>()(name); }

  std::vector<NamedElement> elements_;
};

// Reports parts that have the name of another part's visual geom (NAME_vis).
void CheckVisualNames(const model::Object& object, const NameTable& names,
                      diag::Findings& findings) {
  for (const model::Body& body : object.bodies) {
    for (const model::Part& part : body.parts) {
      if (!part.name.ends_with(model::kVisualSuffix)) continue;
      std::string_view stem = part.name;
      stem.remove_suffix(model::kVisualSuffix.size());
      const NamedElement* twin = names.Find("part", stem);
      if (twin == nullptr || twin->part->role == model::Role::kCollision || twin->part->as_is)
        continue;
      // Skips visual parts, because the geom of a visual part "a_vis" is named "a_vis_vis".
      if (!part.as_is && part.role == model::Role::kVisual) continue;
      ReportRepeatedName("part", part.name, part.mark, twin->mark,
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

std::string MissingNameHint(const model::Object& object, std::string_view full_name,
                            std::string_view shown, std::span<const std::string_view> known) {
  for (const std::string& body : object.left_out) {
    if (full_name.starts_with(body) &&
        (full_name.size() == body.size() || full_name[body.size()] == '_'))
      return fmt::format("body '{}' found no room, and was left out (`fewer: true`)",
                         model::OwnName(body, object.name));
  }
  return diag::DidYouMean(shown, known);
}

void ReportRepeatedName(std::string_view kind, const std::string& name, diag::SourceMark second,
                        diag::SourceMark first, std::string hint, diag::Findings& findings) {
  const bool same_entry = second == first;
  if (same_entry && hint.empty()) hint = "put the variable of 'for' into the name, as in wall_${i}";
  diag::Finding& finding =
      findings.Add(diag::Code::kModelDuplicateName, second,
                   fmt::format("two {} are named '{}'",
                               kind == "body" ? "bodies" : fmt::format("{}s", kind), name),
                   std::move(hint));
  if (!same_entry) finding.notes.push_back({first, "the other one"});
}

void CheckUniqueNames(const model::Object& object, diag::Findings& findings) {
  NameTable names;
  names.AddAll("material", object.materials);
  names.AddAll("texture", object.textures);
  for (const auto& mesh : object.meshes) names.Add("mesh", mesh->name, mesh->mark);
  names.AddAll("body", object.bodies);
  for (const model::Body& body : object.bodies) {
    names.AddAll("joint", body.joints);
    names.AddAll("site", body.sites);
    for (const model::Part& part : body.parts) names.Add("part", part.name, part.mark, &part);
    for (const model::Element& view : body.elements) names.Add(view.tag, view.name, view.mark);
  }
  names.ReportDuplicates(findings);
  CheckVisualNames(object, names, findings);
  NameTable section_names;
  for (const model::Section& section : object.sections) {
    if (!section.info->is_element) section_names.AddAll(section.info->name, section.elements);
  }
  section_names.ReportDuplicates(findings);
}

}  // namespace mjforge::assemble
