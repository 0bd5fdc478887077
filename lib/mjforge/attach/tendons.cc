// Copies tendons of the compiled model (mjModel) into an attachment, a body of an MJCF file for use
// in a spec.
#include <algorithm>
#include <string>
#include <vector>

#include "mjforge/attach/section_reader.h"

namespace mjforge::attach {
namespace {

// Colour (rgba) of spatial tendons, and MuJoCo's default, which is not written.
constexpr compiled::ArrayField kRgba[] = {{"rgba", &mjModel::tendon_rgba, 4, {{0.5, 0.5, 0.5, 1}}}};

/// Adds an element for each joint, site, geom or pulley on the path of a tendon.
void WritePath(const SectionReader& sections, int id, const spec::ElementInfo& info,
               model::Element& tendon) {
  const mjModel& m = sections.model();
  for (int i = m.tendon_adr[id]; i < m.tendon_adr[id] + m.tendon_num[id]; ++i) {
    const auto [tag, kind, object, side] = compiled::WrapAt(m, i);
    const auto child = std::ranges::find(info.children, tag, &spec::ElementInfo::name);
    if (child == info.children.end()) continue;
    model::Element& wrap = tendon.children.emplace_back();
    wrap.tag = child->name;
    wrap.mark = tendon.mark;
    Attributes attributes(*child, wrap.attributes);
    if (tag == "pulley") {
      attributes.Number("divisor", m.wrap_prm[i]);
      continue;
    }
    attributes.Text(tag, sections.NameOf({kind, object}));
    if (side >= 0) attributes.Text("sidesite", sections.NameOf({mjOBJ_SITE, side}));
    if (tag == "joint") attributes.Number("coef", m.wrap_prm[i]);
  }
}

}  // namespace

void ReadTendons(SectionReader& sections, AssetReader& assets) {
  const mjModel& m = sections.model();
  for (int i = 0; i < m.ntendon; ++i) {
    const bool fixed = m.wrap_type[m.tendon_adr[i]] == mjWRAP_JOINT;
    const std::string_view tag = fixed ? "fixed" : "spatial";
    std::vector<Reference> references;
    for (int k = 0; k < m.tendon_num[i]; ++k) {
      const compiled::Wrap wrap = compiled::WrapAt(m, m.tendon_adr[i] + k);
      references.push_back({wrap.kind, wrap.object});
      references.push_back({mjOBJ_SITE, wrap.side});
    }
    auto tendon = sections.Add("tendon", tag, mjOBJ_TENDON, i, references);
    if (!tendon) continue;
    tendon->attributes.Read(m, mjOBJ_TENDON, i);
    if (!fixed) {
      tendon->attributes.Number("width", m.tendon_width[i], 0.003);
      const std::string material = assets.MaterialName(m.tendon_matid[i]);
      if (!material.empty()) tendon->attributes.Text("material", material);
      tendon->attributes.Read(m, kRgba, i);
    }
    WritePath(sections, i, *spec::FindSection("tendon")->Find(tag), tendon->element);
  }
}

}  // namespace mjforge::attach
