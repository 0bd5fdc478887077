// The table of the MJCF sections that a spec may contain under `mjcf:`.
//
// Source: mj_printSchema of MuJoCo 2.2.2, with the kinds of references from its XML reference; a
// test compares the two. The equality `distance` is left out, because MuJoCo 3 rejects it.

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "mjforge/expr/expr.h"
#include "mjforge/spec/mjcf_sections.h"

namespace mjforge::spec {
namespace {

// MJCF elements with the same attributes: their names, then the attributes. Suffixes give the type
// of an attribute: `#` numbers, `#1,2` numbers with these defaults, `?` true or false, `=kind` the
// name of an element of this kind; without a suffix, the attribute is text. Following lines of
// greater depth are elements allowed inside these elements. The attribute `class` is left out,
// because generated files have no defaults.
struct SchemaLine {
  std::string_view section;  // empty: that of the line before
  int depth;
  std::string_view elements;
  std::string_view attributes;
};

#define MJFORGE_EQUALITY " active? solref# solimp#"
#define MJFORGE_TENDON                                                                     \
  "name group# limited? range# solreflimit# solimplimit# solreffriction# solimpfriction# " \
  "frictionloss# springlength#-1 margin# stiffness# damping# user#"
#define MJFORGE_TRANSMISSION                                                                \
  "name group# forcelimited? ctrlrange# forcerange# lengthrange# gear# cranklength# user# " \
  "joint=joint jointinparent=joint tendon=tendon slidersite=site cranksite=site "
#define MJFORGE_ACTUATOR MJFORGE_TRANSMISSION "site=site refsite=site ctrllimited? "
#define MJFORGE_SENSED " cutoff# noise# user#"

constexpr SchemaLine kLines[] = {
    {"option", 0, "option",
     "timestep# apirate# impratio# tolerance# noslip_tolerance# mpr_tolerance# gravity# wind# "
     "magnetic# density# viscosity# o_margin# o_solref# o_solimp# integrator collision cone "
     "jacobian solver iterations# noslip_iterations# mpr_iterations#"},
    {"", 1, "flag",
     "constraint equality frictionloss limit contact passive gravity clampctrl warmstart "
     "filterparent actuation refsafe sensor override energy fwdinv sensornoise multiccd"},
    {"size", 0, "size",
     "njmax# nconmax# nstack# nuserdata# nkey# nuser_body# nuser_jnt# nuser_geom# nuser_site# "
     "nuser_cam# nuser_tendon# nuser_actuator# nuser_sensor#"},
    {"visual", 0, "visual", ""},
    {"", 1, "global", "fovy# ipd# azimuth# elevation# linewidth# glow# offwidth# offheight#"},
    {"", 1, "quality", "shadowsize# offsamples# numslices# numstacks# numquads#"},
    {"", 1, "headlight", "ambient# diffuse# specular# active#"},
    {"", 1, "map",
     "stiffness# stiffnessrot# force# torque# alpha# fogstart# fogend# znear# zfar# haze# "
     "shadowclip# shadowscale# actuatortendon#"},
    {"", 1, "scale",
     "forcewidth# contactwidth# contactheight# connect# com# camera# light# selectpoint# "
     "jointlength# jointwidth# actuatorlength# actuatorwidth# framelength# framewidth# "
     "constraint# slidercrank#"},
    {"", 1, "rgba",
     "fog# haze# force# inertia# joint# actuator# actuatornegative# actuatorpositive# com# "
     "camera# light# selectpoint# connect# contactpoint# contactforce# contactfriction# "
     "contacttorque# contactgap# rangefinder# constraint# slidercrank# crankbroken#"},
    {"statistic", 0, "statistic", "meaninertia# meanmass# meansize# extent# center#"},
    {"custom", 0, "numeric", "name size# data#"},
    {"", 0, "text", "name data"},
    {"", 0, "tuple", "name"},
    {"", 1, "element", "objtype objname=@objtype prm#"},
    {"contact", 0, "pair",
     "name geom1=geom geom2=geom condim# friction# solref# solimp# gap# margin#"},
    {"", 0, "exclude", "name body1=body body2=body"},
    {"equality", 0, "connect", "name body1=body body2=body anchor#" MJFORGE_EQUALITY},
    {"", 0, "weld", "name body1=body body2=body relpose# anchor# torquescale#" MJFORGE_EQUALITY},
    {"", 0, "joint", "name joint1=joint joint2=joint polycoef#0,1,0,0,0" MJFORGE_EQUALITY},
    {"", 0, "tendon", "name tendon1=tendon tendon2=tendon polycoef#0,1,0,0,0" MJFORGE_EQUALITY},
    {"tendon", 0, "spatial", MJFORGE_TENDON " width# material=material rgba#"},
    {"", 1, "site", "site=site"},
    {"", 1, "geom", "geom=geom sidesite=site"},
    {"", 1, "pulley", "divisor#"},
    {"", 0, "fixed", MJFORGE_TENDON},
    {"", 1, "joint", "joint=joint coef#"},
    {"actuator", 0, "general",
     MJFORGE_ACTUATOR "actlimited? actrange# body=body dyntype gaintype biastype dynprm# gainprm# "
                      "biasprm#"},
    {"", 0, "motor", MJFORGE_ACTUATOR},
    {"", 0, "position", MJFORGE_ACTUATOR "kp#"},
    {"", 0, "velocity", MJFORGE_ACTUATOR "kv#"},
    {"", 0, "intvelocity", MJFORGE_ACTUATOR "actrange# kp#"},
    {"", 0, "damper", MJFORGE_TRANSMISSION "site=site refsite=site kv#"},
    {"", 0, "cylinder", MJFORGE_ACTUATOR "timeconst# area# diameter# bias#"},
    {"", 0, "muscle",
     MJFORGE_TRANSMISSION
     "ctrllimited? timeconst# range# force# scale# lmin# lmax# vmax# fpmax# fvmax#"},
    {"", 0, "adhesion", "name group# forcelimited? ctrlrange# forcerange# user# body=body gain#"},
    {"sensor", 0, "touch accelerometer velocimeter gyro force torque magnetometer rangefinder",
     "name site=site" MJFORGE_SENSED},
    {"", 0, "jointpos jointvel", "name joint=joint" MJFORGE_SENSED},
    {"", 0, "tendonpos tendonvel", "name tendon=tendon" MJFORGE_SENSED},
    {"", 0, "actuatorpos actuatorvel actuatorfrc", "name actuator=actuator" MJFORGE_SENSED},
    {"", 0, "ballquat ballangvel jointlimitpos jointlimitvel jointlimitfrc",
     "name joint=joint" MJFORGE_SENSED},
    {"", 0, "tendonlimitpos tendonlimitvel tendonlimitfrc", "name tendon=tendon" MJFORGE_SENSED},
    {"", 0, "framepos framequat framexaxis frameyaxis framezaxis framelinvel frameangvel",
     "name objtype objname=@objtype reftype refname=@reftype" MJFORGE_SENSED},
    {"", 0, "framelinacc frameangacc", "name objtype objname=@objtype" MJFORGE_SENSED},
    {"", 0, "subtreecom subtreelinvel subtreeangmom", "name body=body" MJFORGE_SENSED},
    {"", 0, "clock", "name" MJFORGE_SENSED},
    {"", 0, "user", "name objtype objname=@objtype datatype needstage dim#" MJFORGE_SENSED},
};

// Elements inside a body besides geoms, joints and sites, with the attributes that generated files
// use.
constexpr SchemaLine kBodyLines[] = {
    {"body", 0, "camera", "name fovy# ipd# pos# quat# mode target=body user#"},
    {"", 0, "light",
     "name directional? castshadow? active? pos# dir# attenuation# cutoff# exponent# ambient# "
     "diffuse# specular# mode target=body"},
};

#undef MJFORGE_EQUALITY
#undef MJFORGE_TENDON
#undef MJFORGE_TRANSMISSION
#undef MJFORGE_ACTUATOR
#undef MJFORGE_SENSED

// Maximum length of a list of numbers. Only the attributes `data` and `user` may be so long.
constexpr int kMostNumbers = 500;

FieldInfo Parse(std::string_view word) {
  FieldInfo field;
  const std::size_t end = word.find_first_of("#?=");
  field.key = word.substr(0, end);
  field.kind = FieldKind::kText;
  if (field.key == "name") field.id = Key::kName;
  if (end == std::string_view::npos) return field;
  if (word[end] == '#') {
    field.kind = FieldKind::kNumbers;
    field.max_count = kMostNumbers;
    field.any_unit = true;
    field.default_text = word.substr(end + 1);
    if (field.key == "timestep") {
      field.lower = 0;
      field.above = true;
    }
  } else if (word[end] == '?') {
    field.kind = FieldKind::kBoolean;
  } else {
    field.refers = word.substr(end + 1);
  }
  return field;
}

// Table made from the lines. Spans in the table refer to vectors in deques, whose addresses never
// change.
class SchemaTable {
 public:
  explicit SchemaTable(std::span<const SchemaLine> lines) {
    while (!lines.empty()) {
      const auto section =
          TakeUntil([](const SchemaLine& line) { return !line.section.empty(); }, lines);
      const SchemaLine& first = section.front();
      sections_.push_back({first.section, first.section == first.elements, ElementsOf(section, 0)});
    }
  }

  std::span<const SectionInfo> sections() const { return sections_; }

 private:
  // Removes the first line of `lines`, and all lines after it up to the next line for which
  // is_next() returns true. Returns the removed lines.
  template <typename IsNext>
  static std::span<const SchemaLine> TakeUntil(IsNext is_next, std::span<const SchemaLine>& lines) {
    const auto next = std::ranges::find_if(lines.subspan(1), is_next);
    const auto count = static_cast<std::size_t>(next - lines.begin());
    return std::exchange(lines, lines.subspan(count)).first(count);
  }

  std::span<const ElementInfo> ElementsOf(std::span<const SchemaLine> lines, int depth) {
    std::vector<ElementInfo>& elements = elements_.emplace_back();
    while (!lines.empty()) {
      const auto taken =
          TakeUntil([depth](const SchemaLine& line) { return line.depth == depth; }, lines);
      const auto fields = FieldsOf(taken.front().attributes);
      const auto children = ElementsOf(taken.subspan(1), depth + 1);
      for (const std::string_view name : expr::WordsOf(taken.front().elements))
        elements.push_back({name, {}, fields, children});
    }
    return elements;
  }

  std::span<const FieldInfo> FieldsOf(std::string_view attributes) {
    std::vector<FieldInfo>& fields = fields_.emplace_back();
    for (const std::string_view word : expr::WordsOf(attributes)) fields.push_back(Parse(word));
    return fields;
  }

  std::deque<std::vector<FieldInfo>> fields_;
  std::deque<std::vector<ElementInfo>> elements_;
  std::vector<SectionInfo> sections_;
};

}  // namespace

const ElementInfo* SectionInfo::Find(std::string_view element) const {
  return diag::Find(elements, element, &ElementInfo::name);
}

std::span<const SectionInfo> Sections() {
  static const SchemaTable table(kLines);
  return table.sections();
}

const SectionInfo* FindSection(std::string_view name) {
  return diag::Find(Sections(), name, &SectionInfo::name);
}

const ElementInfo* FindBodyChild(std::string_view name) {
  static const SchemaTable table(kBodyLines);
  return table.sections().front().Find(name);
}

}  // namespace mjforge::spec
