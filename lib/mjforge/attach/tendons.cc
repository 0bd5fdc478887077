#include <algorithm>
#include <string>
#include <vector>

#include "mjforge/attach/section_reader.h"

namespace mjforge::attach {
namespace {

// Of spatial ones.
constexpr compiled::ArrayField kRgba[] = {{"rgba", &mjModel::tendon_rgba, 4, {{0.5, 0.5, 0.5, 1}}}};

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
      const compiled::Wrap wrap = compiled::WrapAt(m_, i);
      references.push_back({wrap.kind, wrap.object});
      references.push_back({mjOBJ_SITE, wrap.side});
    }
    return references;
  }

  void Write(model::Element& tendon) const {
    for (int i = begin_; i < end_; ++i) {
      const auto [tag, kind, object, side] = compiled::WrapAt(m_, i);
      const auto info = std::ranges::find(info_.children, tag, &spec::ElementInfo::name);
      if (info == info_.children.end()) continue;
      model::Element& wrap = tendon.children.emplace_back();
      wrap.tag = info->name;
      wrap.mark = tendon.mark;
      Attributes attributes(*info, wrap.attributes);
      if (tag == "pulley") {
        attributes.Number("divisor", m_.wrap_prm[i]);
        continue;
      }
      attributes.Text(tag, sections_.NameOf({kind, object}));
      if (side >= 0) attributes.Text("sidesite", sections_.NameOf({mjOBJ_SITE, side}));
      if (tag == "joint") attributes.Number("coef", m_.wrap_prm[i]);
    }
  }

 private:
  SectionReader& sections_;
  const mjModel& m_;
  int begin_;
  int end_;
  const spec::ElementInfo& info_;
};

}  // namespace

void ReadTendons(SectionReader& sections, AssetReader& assets) {
  const mjModel& m = sections.model();
  for (int i = 0; i < m.ntendon; ++i) {
    const bool fixed = m.wrap_type[m.tendon_adr[i]] == mjWRAP_JOINT;
    const std::string_view tag = fixed ? "fixed" : "spatial";
    const Wraps wraps(sections, i, tag);
    model::Element* tendon = sections.Add("tendon", tag, mjOBJ_TENDON, i, wraps.References());
    if (tendon == nullptr) continue;
    Attributes attributes = SectionReader::Of("tendon", *tendon);
    attributes.Read(m, mjOBJ_TENDON, i);
    if (!fixed) {
      attributes.Number("width", m.tendon_width[i], 0.003);
      const std::string material = assets.MaterialName(m.tendon_matid[i]);
      if (!material.empty()) attributes.Text("material", material);
      attributes.Read(m, kRgba, i);
    }
    wraps.Write(*tendon);
  }
}

}  // namespace mjforge::attach
