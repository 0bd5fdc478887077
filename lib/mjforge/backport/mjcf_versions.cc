// Tables of the elements and attributes that MJCF gained after MuJoCo 2.2.2, and of lists of
// numbers whose lengths changed.
#include "mjforge/backport/mjcf_versions.h"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include "mjforge/diag/diag.h"

namespace mjforge::backport {
namespace {

constexpr std::string_view kActuators[] = {"general",  "motor",       "position",
                                           "velocity", "intvelocity", "damper",
                                           "cylinder", "muscle",      "adhesion"};

constexpr MjcfFeature kElements[] = {
    {"body/frame", "", 312, Effect::kExpansion},
    {"body/replicate", "", 315, Effect::kExpansion},
    {"body/attach asset/model", "", 320, Effect::kInclusion},
    {"body/flexcomp deformable/flex equality/flex", "", 300},
    {"equality/flexvert", "", 3005000},
    {"equality/flexstrain", "", 3006000},
    {"mujoco/deformable", "", 300, Effect::kLooks},  // contains skins and flexes
    {"mesh/plugin geom/plugin", "", 300},
    {"extension plugin", "", 230},
    {"actuator/dcmotor default/dcmotor", "", 3007000},
    {"actuator/orientation default/orientation", "", 3011000},
    {"actuator/pid default/pid", "", 3012000},
    {"material/rgb material/rgba material/normal material/occlusion material/roughness "
     "material/metallic material/opacity material/emissive material/orm",
     "", 321, Effect::kLooks},
    {"material/layer", "", 325, Effect::kLooks},
    {"default/texture", "", 3017000, Effect::kLooks},
    {"sensor/camprojection", "", 300, Effect::kReading},
    {"sensor/jointactuatorfrc", "", 237, Effect::kReading},
    {"sensor/tendonactuatorfrc", "", 331, Effect::kReading},
    {"sensor/distance sensor/normal sensor/fromto", "", 316, Effect::kReading},
    {"sensor/e_potential sensor/e_kinetic", "", 330, Effect::kReading},
    {"sensor/contact sensor/insidesite sensor/tactile", "", 335, Effect::kReading},
};

constexpr MjcfFeature kAttributes[] = {
    // Attributes of elements that set options of the whole model.
    {"compiler", "assetdir", 230},
    {"compiler", "alignfree", 323, Effect::kMeaning, "false"},
    {"compiler", "saveinertial", 331, Effect::kSpeed},
    {"compiler", "conflict", 3010000, Effect::kSpeed},
    {"compiler", "savecanonical savecompiled", 3016000, Effect::kSpeed},
    {"compiler", "passthrough", 3017000, Effect::kSpeed},
    {"lengthrange", "interval", 233},
    {"size", "memory", 230, Effect::kSpeed},
    {"option", "integrator=implicitfast", 233, Effect::kSimulation},
    {"option", "ls_iterations ls_tolerance sdf_initpoints sdf_iterations", 300, Effect::kSpeed},
    {"option", "o_friction", 300, Effect::kSimulation},
    {"option", "actuatorgroupdisable", 301, Effect::kSimulation},
    {"option", "ccd_iterations ccd_tolerance", 323, Effect::kSpeed},
    {"option", "sleep_tolerance", 340, Effect::kSpeed},
    {"flag", "eulerdamp invdiscrete island midphase", 300, Effect::kSimulation},
    {"flag", "autoreset", 321, Effect::kSimulation},
    {"flag", "nativeccd", 323, Effect::kSimulation},
    {"flag", "damper spring", 336, Effect::kSimulation},
    {"flag", "sleep", 340, Effect::kSpeed},
    {"flag", "diagexact", 3009000, Effect::kSimulation},
    {"flag", "ipc", 3014000, Effect::kSimulation},
    {"flag", "speculative", 4000000, Effect::kSimulation},
    {"visual/global", "realtime", 230, Effect::kLooks},
    {"visual/global", "ellipsoidinertia", 234, Effect::kLooks},
    {"visual/global", "bvactive", 312, Effect::kLooks},
    {"visual/global", "orthographic", 320, Effect::kLooks},
    {"visual/global", "cameraid", 334, Effect::kLooks},
    {"visual/rgba", "bv bvactive", 312, Effect::kLooks},
    {"visual/rgba visual/scale", "frustum", 301, Effect::kLooks},
    {"keyframe/key", "plastic", 4000000},
    // Attributes of assets.
    {"mesh hfield texture", "content_type", 237},
    {"hfield", "elevation", 312},
    {"material", "metallic roughness", 315, Effect::kLooks},
    {"texture", "nchannel", 321, Effect::kLooks},
    {"texture", "colorspace", 333, Effect::kLooks},
    {"texture", "class embed", 3017000, Effect::kLooks},
    {"asset/mesh default/mesh", "maxhullvert", 320, Effect::kSpeed},
    {"asset/mesh default/mesh", "inertia=shell", 330},
    {"asset/mesh default/mesh", "inertia", 325, Effect::kMeaning, "legacy"},
    {"asset/mesh", "builtin params", 335},
    {"asset/mesh", "material", 336, Effect::kLooks},
    // Attributes of bodies, and of elements in bodies.
    {"body", "gravcomp", 231, Effect::kMeaning, "0"},
    {"body", "sleep", 340, Effect::kSpeed},
    {"body", "simple", 3011000, Effect::kSpeed},
    {"body", "fuse", 3016000, Effect::kMeaning, "auto"},
    {"freejoint", "align", 323, Effect::kMeaning, "false"},
    {"body/joint default/joint", "actuatorforcerange actuatorforcelimited", 237},
    {"body/joint default/joint", "actuatorfrcrange actuatorfrclimited", 300},
    {"body/joint default/joint", "actuatorgravcomp", 314, Effect::kMeaning, "false"},
    {"body/joint default/joint", "springyield", 4000000},
    {"geom", "type=sdf", 300},
    {"geom", "adhesion", 3011000, Effect::kMeaning, "0"},
    {"geom", "surfacevel", 3011000},
    {"geom", "castshadow", 4000000, Effect::kLooks},
    {"site", "mesh", 3013000, Effect::kLooks},
    {"camera", "focal focalpixel sensorsize", 300},
    {"camera", "principal principalpixel resolution", 300, Effect::kLooks},
    {"camera", "orthographic", 320, Effect::kMeaning, "false"},
    {"camera", "projection", 3005000, Effect::kMeaning, "perspective"},
    {"camera", "output", 3005000, Effect::kLooks},
    {"light", "bulbradius", 315, Effect::kLooks},
    {"light", "intensity range texture type", 333, Effect::kLooks},
    {"light", "softness", 3012000, Effect::kLooks},
    {"composite", "type=cable", 230},
    {"composite", "curve initial size vertex", 230},
    {"composite", "quat", 331},
    // Attributes of elements in other sections.
    {"pair", "solreffriction", 236, Effect::kMeaning, "0 0"},
    {"pair", "adhesion", 3011000, Effect::kMeaning, "0"},
    {"equality/connect equality/weld", "site1 site2", 323},
    {"tendon/*", "actuatorfrcrange actuatorfrclimited", 331},
    {"tendon/*", "armature", 331, Effect::kMeaning, "0"},
    {"tendon/*", "springyield", 4000000},
    {"actuator/*", "actdim", 231},
    {"actuator/*", "tausmooth", 236, Effect::kMeaning, "0"},
    {"actuator/*", "actearly", 300, Effect::kMeaning, "false"},
    {"actuator/*", "dyntype=filterexact", 300},
    {"position intvelocity", "kv", 310},
    {"general", "inheritrange", 3016000, Effect::kMeaning, "0"},
    {"actuator/*", "inheritrange", 313, Effect::kMeaning, "0"},
    {"position intvelocity", "dampratio", 316, Effect::kMeaning, "0"},
    {"position", "timeconst", 316, Effect::kMeaning, "0"},
    {"actuator/*", "nsample delay", 3005000, Effect::kMeaning, "0"},
    {"actuator/*", "interp", 3005000, Effect::kMeaning, "zoh"},
    {"actuator/*", "damping armature", 3007000, Effect::kMeaning, "0"},
    {"intvelocity", "actlimited", 3011000, Effect::kMeaning, "true"},
    {"actuator/*", "input", 3011000},
    {"actuator/*", "ffrange velrange", 3012000},
    {"sensor/*", "nsample delay interval", 3005000, Effect::kMeaning, "0"},
    {"sensor/*", "interp", 3005000, Effect::kMeaning, "zoh"},
    {"sensor/rangefinder", "camera data", 3005000},
};

constexpr MjcfList kLists[] = {
    {"equality/joint equality/tendon", "polycoef", 316, 5, "0 1 0 0 0"},
    {"tendon/spatial tendon/fixed default/tendon", "springlength", 231, 2, "-1"},
    {"body/joint default/joint tendon/spatial tendon/fixed default/tendon", "stiffness damping",
     3007000, 3, "0", "0"},
};

/// Calls `use` with each word of the text until `use` returns true; returns false if `use` never
/// does.
template <typename Use>
bool AnyWord(std::string_view text, const Use& use) {
  while (!text.empty()) {
    if (use(diag::CutAt(' ', text))) return true;
  }
  return false;
}

}  // namespace

bool IsAt(std::string_view where, std::string_view parent, std::string_view tag) {
  return AnyWord(where, [&](std::string_view place) {
    const std::size_t slash = place.find('/');
    if (slash == std::string_view::npos) return place == tag;
    const std::string_view above = place.substr(0, slash);
    const std::string_view below = place.substr(slash + 1);
    if (below == "*") return above == ElementKindOf(parent, tag);
    const bool within_body =
        above == "body" && (parent == "worldbody" || parent == "frame" || parent == "replicate");
    return below == tag && (above == parent || within_body);
  });
}

bool HasAttribute(std::string_view names, std::string_view attribute, std::string_view value) {
  return AnyWord(names, [&](std::string_view name) {
    const std::size_t equals = name.find('=');
    if (equals == std::string_view::npos) return name == attribute;
    return name.substr(0, equals) == attribute && name.substr(equals + 1) == value;
  });
}

const MjcfFeature* FindFeature(std::string_view parent, std::string_view tag) {
  for (const MjcfFeature& row : kElements) {
    if (IsAt(row.where, parent, tag)) return &row;
  }
  return nullptr;
}

const MjcfFeature* FindFeature(std::string_view parent, std::string_view tag,
                               std::string_view attribute, std::string_view value) {
  for (const MjcfFeature& row : kAttributes) {
    if (HasAttribute(row.names, attribute, value) && IsAt(row.where, parent, tag)) return &row;
  }
  return nullptr;
}

const MjcfList* FindList(std::string_view parent, std::string_view tag,
                         std::string_view attribute) {
  for (const MjcfList& row : kLists) {
    const auto same = [&](std::string_view name) { return name == attribute; };
    if (AnyWord(row.names, same) && IsAt(row.where, parent, tag)) return &row;
  }
  return nullptr;
}

std::string_view ElementKindOf(std::string_view parent, std::string_view tag) {
  if (parent == "actuator" || parent == "sensor" || parent == "equality") return parent;
  if (parent == "tendon") return parent;
  if (parent != "default") return tag;
  return std::ranges::find(kActuators, tag) == std::end(kActuators) ? tag : "actuator";
}

std::string VersionText(int header) {
  const int step = header < 1000000 ? 10 : 1000;
  return fmt::format("{}.{}.{}", header / step / step, header / step % step, header % step);
}

}  // namespace mjforge::backport
