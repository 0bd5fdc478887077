#include <string>
#include <vector>

#include "mjforge/attach/section_reader.h"

namespace mjforge::attach {
namespace {

/// Adds what a tendon passes, one element each.
class Wraps {
 public:
  Wraps(SectionReader& sections, int tendon, std::string_view tag)
      : sections_(sections),
        m_(sections.model()),
        begin_(m_.tendon_adr[tendon]),
        end_(begin_ + m_.tendon_num[tendon]),
        info_(*spec::FindSection("tendon")->Find(tag)) {}

  std::vector<Reference> References() const {
    std::vector<Reference> references;
    for (int i = begin_; i < end_; ++i) {
      references.push_back(ObjectOf(i));
      references.push_back(SideOf(i));
    }
    return references;
  }

  void Write(model::Element& tendon) const {
    for (int i = begin_; i < end_; ++i) {
      const std::string_view tag = TagOf(i);
      const spec::ElementInfo* info = nullptr;
      for (const spec::ElementInfo& child : info_.children) {
        if (child.name == tag) info = &child;
      }
      if (info == nullptr) continue;
      model::Element& wrap = tendon.children.emplace_back();
      wrap.tag = info->name;
      wrap.mark = tendon.mark;
      Attributes attributes(*info, wrap.attributes);
      if (tag == "pulley") {
        attributes.Number("divisor", m_.wrap_prm[i]);
        continue;
      }
      attributes.Text(tag, sections_.NameOf(ObjectOf(i)));
      if (SideOf(i).id >= 0) attributes.Text("sidesite", sections_.NameOf(SideOf(i)));
      if (tag == "joint") attributes.Number("coef", m_.wrap_prm[i]);
    }
  }

 private:
  std::string_view TagOf(int i) const {
    switch (m_.wrap_type[i]) {
      case mjWRAP_JOINT:
        return "joint";
      case mjWRAP_PULLEY:
        return "pulley";
      case mjWRAP_SITE:
        return "site";
      default:
        return "geom";
    }
  }

  Reference ObjectOf(int i) const {
    const std::string_view tag = TagOf(i);
    if (tag == "pulley") return {};
    const mjtObj kind = tag == "joint" ? mjOBJ_JOINT : tag == "site" ? mjOBJ_SITE : mjOBJ_GEOM;
    return {kind, m_.wrap_objid[i]};
  }

  Reference SideOf(int i) const {
    if (TagOf(i) != "geom") return {};
    return {mjOBJ_SITE, static_cast<int>(m_.wrap_prm[i])};
  }

  SectionReader& sections_;
  const mjModel& m_;
  int begin_;
  int end_;
  const spec::ElementInfo& info_;
};

void WriteTendon(const mjModel& m, int i, Attributes attributes) {
  const bool limited = m.tendon_limited[i] != 0;
  attributes.Number("group", m.tendon_group[i], 0);
  attributes.Flag("limited", limited);
  if (limited) attributes.Numbers("range", Row(m.tendon_range, i, 2));
  attributes.Numbers("solreflimit", Row(m.tendon_solref_lim, i, mjNREF), kSolref);
  attributes.Numbers("solimplimit", Row(m.tendon_solimp_lim, i, mjNIMP), kSolimp);
  attributes.Numbers("solreffriction", Row(m.tendon_solref_fri, i, mjNREF), kSolref);
  attributes.Numbers("solimpfriction", Row(m.tendon_solimp_fri, i, mjNIMP), kSolimp);
  attributes.Number("frictionloss", m.tendon_frictionloss[i], 0);
  attributes.Number("springlength", m.tendon_lengthspring[i]);
  attributes.Number("margin", m.tendon_margin[i], 0);
  attributes.Number("stiffness", m.tendon_stiffness[i], 0);
  attributes.Number("damping", m.tendon_damping[i], 0);
  attributes.User(Row(m.tendon_user, i, m.nuser_tendon));
}

}  // namespace

void ReadTendons(SectionReader& sections, AssetReader& assets) {
  const mjModel& m = sections.model();
  for (int i = 0; i < m.ntendon; ++i) {
    const bool fixed = m.wrap_type[m.tendon_adr[i]] == mjWRAP_JOINT;
    const std::string_view tag = fixed ? "fixed" : "spatial";
    const Wraps wraps(sections, i, tag);
    model::Element* tendon = sections.Add("tendon", tag, mjOBJ_TENDON, i, wraps.References());
    if (tendon == nullptr) continue;
    WriteTendon(m, i, SectionReader::Of("tendon", *tendon));
    if (!fixed) {
      Attributes look = SectionReader::Of("tendon", *tendon);
      look.Number("width", m.tendon_width[i], 0.003);
      const std::string material = assets.MaterialName(m.tendon_matid[i]);
      if (!material.empty()) look.Text("material", material);
      look.Numbers("rgba", Row(m.tendon_rgba, i, 4), {0.5, 0.5, 0.5, 1});
    }
    wraps.Write(*tendon);
  }
}

}  // namespace mjforge::attach
