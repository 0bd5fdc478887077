// Copies contacts and equalities of the compiled model (mjModel) into an attachment, a body of an
// MJCF file for use in a spec. Adds the references of elements in all sections.
#include "mjforge/attach/section_reader.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "mjforge/engine/engine.h"

namespace mjforge::attach {

namespace {

/// Returns mjOBJ_BODY for mjOBJ_XBODY, and other kinds unchanged.
mjtObj Plain(mjtObj kind) { return kind == mjOBJ_XBODY ? mjOBJ_BODY : kind; }

}  // namespace

std::optional<SectionReader::Added> SectionReader::Add(std::string_view section,
                                                       std::string_view tag, mjtObj kind, int id,
                                                       const std::vector<Reference>& references) {
  if (!IsCarried(kind, id, references)) return std::nullopt;
  scope_.Add(kind, id);
  const spec::SectionInfo* info = spec::FindSection(section);
  model::Element& element = model::ElementsOf(*info, out_.sections).emplace_back();
  const spec::ElementInfo& element_info = *info->Find(tag);
  element.tag = element_info.name;
  scope_.Label(kind, id, element);
  Attributes attributes(element_info, element.attributes);
  for (const Reference& reference : references) {
    if (reference.id < 0 || reference.attribute.empty()) continue;
    if (!reference.kind_attribute.empty()) {
      attributes.Text(reference.kind_attribute, KindName(reference.kind));
    }
    attributes.Text(reference.attribute, NameOf(reference));
  }
  return Added{element, attributes};
}

std::string SectionReader::NameOf(Reference reference) const {
  return scope_.Name(Plain(reference.kind), reference.id);
}

bool SectionReader::IsCarried(mjtObj kind, int id, const std::vector<Reference>& references) {
  bool inside = references.empty();  // a clock, which measures no element
  const Reference* outside = nullptr;
  for (const Reference& reference : references) {
    if (reference.id < 0) continue;
    const mjtObj plain = Plain(reference.kind);
    if (scope_.Contains(plain, reference.id)) {
      inside = true;
    } else {
      if (outside == nullptr) outside = &reference;
      inside = inside || scope_.IsDropped(plain, reference.id);
    }
  }
  // A sensor of the world may measure the attached body.
  const bool is_of_world = kind == mjOBJ_SENSOR && outside != nullptr &&
                           Plain(outside->kind) == mjOBJ_BODY && outside->id == 0;
  if (outside != nullptr && (inside || is_of_world)) Warn(kind, id, *outside);
  return inside && outside == nullptr;
}

void SectionReader::Warn(mjtObj kind, int id, Reference outside) {
  scope_.Drop(kind, id);
  const diag::SourceMark place = file_.MarkOf(kind, id);
  const bool is_one_of_many = file_.ElementOf(kind, id) == nullptr;
  if (is_one_of_many && !warned_.insert(place).second) return;
  if (file_.OriginOf(kind, id).tag == "composite") {
    AddWarning(findings_, diag::Code::kAttachNotCarried, place,
               fmt::format("a composite of '{}' is only partly carried over: {}s refer to things "
                           "outside the attached body",
                           file_.file().string(), KindName(kind)),
               "attach the body that holds the whole composite");
    return;
  }
  const mjtObj plain = Plain(outside.kind);
  const bool world = plain == mjOBJ_BODY && outside.id == 0;
  AddWarning(findings_, diag::Code::kAttachNotCarried, place,
             fmt::format("{} of '{}' is not carried over: it refers to {}, which is not attached",
                         file_.Description(kind, id), file_.file().string(),
                         world ? "the world" : file_.Description(plain, outside.id)));
}

void SectionReader::Finish() { std::ranges::sort(out_.sections, {}, &model::Section::info); }

void ReadContacts(SectionReader& sections) {
  const mjModel& m = sections.model();
  for (int i = 0; i < m.npair; ++i) {
    auto pair = sections.Add(
        "contact", "pair", mjOBJ_PAIR, i,
        {{mjOBJ_GEOM, m.pair_geom1[i], "geom1"}, {mjOBJ_GEOM, m.pair_geom2[i], "geom2"}});
    if (pair) pair->attributes.Read(m, mjOBJ_PAIR, i);
  }
  for (int i = 0; i < m.nexclude; ++i) {
    const auto [body1, body2] = engine::ExcludedBodies(m, i);
    sections.Add("contact", "exclude", mjOBJ_EXCLUDE, i,
                 {{mjOBJ_BODY, body1, "body1"}, {mjOBJ_BODY, body2, "body2"}});
  }
}

void ReadEqualities(SectionReader& sections) {
  const mjModel& m = sections.model();
  for (int i = 0; i < m.neq; ++i) {
    if (m.eq_type[i] > mjEQ_TENDON) continue;  // `distance`, which MuJoCo rejects since 2.2.2
    const compiled::Equality& type = compiled::kEqualities[m.eq_type[i]];
    auto equality = sections.Add(
        "equality", type.tag, mjOBJ_EQUALITY, i,
        {{type.kind, m.eq_obj1id[i], type.first}, {type.kind, m.eq_obj2id[i], type.second}});
    if (!equality) continue;
    Attributes& attributes = equality->attributes;
    const std::span<const mjtNum> data = Row(m.eq_data, i, mjNEQDATA);
    if (m.eq_type[i] == mjEQ_CONNECT) {
      attributes.Numbers("anchor", data.first(3));
    } else if (m.eq_type[i] == mjEQ_WELD) {
      attributes.Numbers("anchor", data.first(3));
      attributes.Numbers("relpose", data.subspan(3, 7));
      attributes.Number("torquescale", data[10], 1);
    } else {
      attributes.Numbers("polycoef", data.first(5));
    }
    attributes.Read(m, mjOBJ_EQUALITY, i);
  }
}

}  // namespace mjforge::attach
