#include "mjforge/attach/section_reader.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace mjforge::attach {

model::Element* SectionReader::Add(std::string_view section, std::string_view tag, mjtObj kind,
                                   int id, const std::vector<Reference>& references) {
  if (!IsCarried(kind, id, references)) return nullptr;
  taken_.Add(kind, id);
  const spec::SectionInfo* info = spec::FindSection(section);
  auto place = std::ranges::find(out_.sections, info, &model::Section::info);
  if (place == out_.sections.end()) {
    place = out_.sections.insert(place, model::Section{info, {}});
  }
  model::Element& element = place->elements.emplace_back();
  element.tag = info->Find(tag)->name;
  element.name = taken_.Name(kind, id);
  element.mark = file_.MarkOf(kind, id);
  return &element;
}

Attributes SectionReader::Of(std::string_view section, model::Element& element) {
  return {*spec::FindSection(section)->Find(element.tag), element.attributes};
}

std::string SectionReader::NameOf(Reference reference) const {
  return taken_.Name(Plain(reference.kind), reference.id);
}

bool SectionReader::IsCarried(mjtObj kind, int id, const std::vector<Reference>& references) {
  bool inside = false;
  const Reference* outside = nullptr;
  for (const Reference& reference : references) {
    if (reference.id < 0) continue;
    const mjtObj plain = Plain(reference.kind);
    if (taken_.Has(plain, reference.id)) {
      inside = true;
    } else {
      if (outside == nullptr) outside = &reference;
      inside = inside || taken_.IsLeftBehind(plain, reference.id);
    }
  }
  if (inside && outside != nullptr) Warn(kind, id, *outside);
  return inside && outside == nullptr;
}

void SectionReader::Warn(mjtObj kind, int id, Reference outside) {
  taken_.LeaveBehind(kind, id);
  const diag::SourceMark place = file_.MarkOf(kind, id);
  if (file_.ElementOf(kind, id) == nullptr) {
    if (!warned_composites_.insert(place).second) return;
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
    const Reference geom1 = {mjOBJ_GEOM, m.pair_geom1[i]};
    const Reference geom2 = {mjOBJ_GEOM, m.pair_geom2[i]};
    model::Element* pair = sections.Add("contact", "pair", mjOBJ_PAIR, i, {geom1, geom2});
    if (pair == nullptr) continue;
    Attributes attributes = SectionReader::Of("contact", *pair);
    attributes.Text("geom1", sections.NameOf(geom1));
    attributes.Text("geom2", sections.NameOf(geom2));
    attributes.Read(m, mjOBJ_PAIR, i);
  }
  for (int i = 0; i < m.nexclude; ++i) {
    // Two body ids, each plus 1, in 16 bits.
    const Reference body1 = {mjOBJ_BODY, (m.exclude_signature[i] >> 16) - 1};
    const Reference body2 = {mjOBJ_BODY, (m.exclude_signature[i] & 0xFFFF) - 1};
    model::Element* exclude = sections.Add("contact", "exclude", mjOBJ_EXCLUDE, i, {body1, body2});
    if (exclude == nullptr) continue;
    Attributes attributes = SectionReader::Of("contact", *exclude);
    attributes.Text("body1", sections.NameOf(body1));
    attributes.Text("body2", sections.NameOf(body2));
  }
}

void ReadEqualities(SectionReader& sections) {
  const mjModel& m = sections.model();
  for (int i = 0; i < m.neq; ++i) {
    if (m.eq_type[i] > mjEQ_TENDON) continue;  // MuJoCo refuses `distance` since 2.2.2
    const compiled::Equality& type = compiled::kEqualities[m.eq_type[i]];
    const Reference first = {type.kind, m.eq_obj1id[i]};
    const Reference second = {type.kind, m.eq_obj2id[i]};
    model::Element* element =
        sections.Add("equality", type.tag, mjOBJ_EQUALITY, i, {first, second});
    if (element == nullptr) continue;
    Attributes attributes = SectionReader::Of("equality", *element);
    attributes.Text(type.first, sections.NameOf(first));
    if (second.id >= 0) attributes.Text(type.second, sections.NameOf(second));
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
