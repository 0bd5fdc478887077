#include "mjforge/engine/later_mjcf.h"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

namespace mjforge::engine {
namespace {

constexpr std::string_view kActuators[] = {"general",  "motor",       "position",
                                           "velocity", "intvelocity", "damper",
                                           "cylinder", "muscle",      "adhesion"};

constexpr Later kElements[] = {
    {"body/frame", "", 312, Loss::kExpansion},
    {"body/replicate", "", 315, Loss::kExpansion},
    {"body/attach asset/model", "", 320, Loss::kInclusion},
    {"body/flexcomp deformable/flex equality/flex", "", 300},
    {"equality/flexvert", "", 3005000},
    {"equality/flexstrain", "", 3006000},
    {"mujoco/deformable", "", 300, Loss::kLooks},  // skins, and flexes
    {"mesh/plugin geom/plugin", "", 300},
    {"extension plugin", "", 230},
    {"actuator/dcmotor default/dcmotor", "", 3007000},
    {"actuator/orientation default/orientation", "", 3011000},
    {"actuator/pid default/pid", "", 3012000},
    {"material/rgb material/rgba material/normal material/occlusion material/roughness "
     "material/metallic material/opacity material/emissive material/orm",
     "", 321, Loss::kLooks},
    {"material/layer", "", 325, Loss::kLooks},
    {"default/texture", "", 3017000, Loss::kLooks},
    {"sensor/camprojection", "", 300, Loss::kReading},
    {"sensor/jointactuatorfrc", "", 237, Loss::kReading},
    {"sensor/tendonactuatorfrc", "", 331, Loss::kReading},
    {"sensor/distance sensor/normal sensor/fromto", "", 316, Loss::kReading},
    {"sensor/e_potential sensor/e_kinetic", "", 330, Loss::kReading},
    {"sensor/contact sensor/insidesite sensor/tactile", "", 335, Loss::kReading},
};

constexpr Later kAttributes[] = {
    // Settings.
    {"compiler", "assetdir", 230},
    {"compiler", "alignfree", 323, Loss::kMeaning, "false"},
    {"compiler", "saveinertial", 331, Loss::kSpeed},
    {"compiler", "conflict", 3010000, Loss::kSpeed},
    {"compiler", "savecanonical savecompiled", 3016000, Loss::kSpeed},
    {"compiler", "passthrough", 3017000, Loss::kSpeed},
    {"lengthrange", "interval", 233},
    {"size", "memory", 230, Loss::kSpeed},
    {"option", "integrator=implicitfast", 233, Loss::kSimulation},
    {"option", "ls_iterations ls_tolerance sdf_initpoints sdf_iterations", 300, Loss::kSpeed},
    {"option", "o_friction", 300, Loss::kSimulation},
    {"option", "actuatorgroupdisable", 301, Loss::kSimulation},
    {"option", "ccd_iterations ccd_tolerance", 323, Loss::kSpeed},
    {"option", "sleep_tolerance", 340, Loss::kSpeed},
    {"flag", "eulerdamp invdiscrete island midphase", 300, Loss::kSimulation},
    {"flag", "autoreset", 321, Loss::kSimulation},
    {"flag", "nativeccd", 323, Loss::kSimulation},
    {"flag", "damper spring", 336, Loss::kSimulation},
    {"flag", "sleep", 340, Loss::kSpeed},
    {"flag", "diagexact", 3009000, Loss::kSimulation},
    {"flag", "ipc", 3014000, Loss::kSimulation},
    {"flag", "speculative", 4000000, Loss::kSimulation},
    {"visual/global", "realtime", 230, Loss::kLooks},
    {"visual/global", "ellipsoidinertia", 234, Loss::kLooks},
    {"visual/global", "bvactive", 312, Loss::kLooks},
    {"visual/global", "orthographic", 320, Loss::kLooks},
    {"visual/global", "cameraid", 334, Loss::kLooks},
    {"visual/rgba", "bv bvactive", 312, Loss::kLooks},
    {"visual/rgba visual/scale", "frustum", 301, Loss::kLooks},
    {"keyframe/key", "plastic", 4000000},
    // Assets.
    {"mesh hfield texture", "content_type", 237},
    {"hfield", "elevation", 312},
    {"material", "metallic roughness", 315, Loss::kLooks},
    {"texture", "nchannel", 321, Loss::kLooks},
    {"texture", "colorspace", 333, Loss::kLooks},
    {"texture", "class embed", 3017000, Loss::kLooks},
    {"asset/mesh default/mesh", "maxhullvert", 320, Loss::kSpeed},
    {"asset/mesh default/mesh", "inertia=shell", 330},
    {"asset/mesh default/mesh", "inertia", 325, Loss::kMeaning, "legacy"},
    {"asset/mesh", "builtin params", 335},
    {"asset/mesh", "material", 336, Loss::kLooks},
    // Bodies.
    {"body", "gravcomp", 231, Loss::kMeaning, "0"},
    {"body", "sleep", 340, Loss::kSpeed},
    {"body", "simple", 3011000, Loss::kSpeed},
    {"body", "fuse", 3016000, Loss::kMeaning, "auto"},
    {"freejoint", "align", 323, Loss::kMeaning, "false"},
    {"body/joint default/joint", "actuatorforcerange actuatorforcelimited", 237},
    {"body/joint default/joint", "actuatorfrcrange actuatorfrclimited", 300},
    {"body/joint default/joint", "actuatorgravcomp", 314, Loss::kMeaning, "false"},
    {"body/joint default/joint", "springyield", 4000000},
    {"geom", "type=sdf", 300},
    {"geom", "adhesion", 3011000, Loss::kMeaning, "0"},
    {"geom", "surfacevel", 3011000},
    {"geom", "castshadow", 4000000, Loss::kLooks},
    {"site", "mesh", 3013000, Loss::kLooks},
    {"camera", "focal focalpixel sensorsize", 300},
    {"camera", "principal principalpixel resolution", 300, Loss::kLooks},
    {"camera", "orthographic", 320, Loss::kMeaning, "false"},
    {"camera", "projection", 3005000, Loss::kMeaning, "perspective"},
    {"camera", "output", 3005000, Loss::kLooks},
    {"light", "bulbradius", 315, Loss::kLooks},
    {"light", "intensity range texture type", 333, Loss::kLooks},
    {"light", "softness", 3012000, Loss::kLooks},
    {"composite", "type=cable", 230},
    {"composite", "curve initial size vertex", 230},
    {"composite", "quat", 331},
    // Other sections.
    {"pair", "solreffriction", 236, Loss::kMeaning, "0 0"},
    {"pair", "adhesion", 3011000, Loss::kMeaning, "0"},
    {"equality/connect equality/weld", "site1 site2", 323},
    {"tendon/*", "actuatorfrcrange actuatorfrclimited", 331},
    {"tendon/*", "armature", 331, Loss::kMeaning, "0"},
    {"tendon/*", "springyield", 4000000},
    {"actuator/*", "actdim", 231},
    {"actuator/*", "tausmooth", 236, Loss::kMeaning, "0"},
    {"actuator/*", "actearly", 300, Loss::kMeaning, "false"},
    {"actuator/*", "dyntype=filterexact", 300},
    {"position intvelocity", "kv", 310},
    {"general", "inheritrange", 3016000, Loss::kMeaning, "0"},
    {"actuator/*", "inheritrange", 313, Loss::kMeaning, "0"},
    {"position intvelocity", "dampratio", 316, Loss::kMeaning, "0"},
    {"position", "timeconst", 316, Loss::kMeaning, "0"},
    {"actuator/*", "nsample delay", 3005000, Loss::kMeaning, "0"},
    {"actuator/*", "interp", 3005000, Loss::kMeaning, "zoh"},
    {"actuator/*", "damping armature", 3007000, Loss::kMeaning, "0"},
    {"intvelocity", "actlimited", 3011000, Loss::kMeaning, "true"},
    {"actuator/*", "input", 3011000},
    {"actuator/*", "ffrange velrange", 3012000},
    {"sensor/*", "nsample delay interval", 3005000, Loss::kMeaning, "0"},
    {"sensor/*", "interp", 3005000, Loss::kMeaning, "zoh"},
    {"sensor/rangefinder", "camera data", 3005000},
};

/// Calls `use` with each word until it says true.
template <typename Use>
bool AnyWord(std::string_view text, const Use& use) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (use(text.substr(0, end))) return true;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

bool IsAt(const Later& row, std::string_view parent, std::string_view tag) {
  return AnyWord(row.where, [&](std::string_view place) {
    const std::size_t slash = place.find('/');
    if (slash == std::string_view::npos) return place == tag;
    const std::string_view above = place.substr(0, slash);
    const std::string_view below = place.substr(slash + 1);
    if (below == "*") return above == SectionOf(parent, tag);
    const bool within_body =
        above == "body" && (parent == "worldbody" || parent == "frame" || parent == "replicate");
    return below == tag && (above == parent || within_body);
  });
}

bool Says(const Later& row, std::string_view attribute, std::string_view value) {
  return AnyWord(row.names, [&](std::string_view name) {
    const std::size_t equals = name.find('=');
    if (equals == std::string_view::npos) return name == attribute;
    return name.substr(0, equals) == attribute && name.substr(equals + 1) == value;
  });
}

}  // namespace

const Later* FindLater(std::string_view parent, std::string_view tag) {
  for (const Later& row : kElements) {
    if (IsAt(row, parent, tag)) return &row;
  }
  return nullptr;
}

const Later* FindLater(std::string_view parent, std::string_view tag, std::string_view attribute,
                       std::string_view value) {
  for (const Later& row : kAttributes) {
    if (Says(row, attribute, value) && IsAt(row, parent, tag)) return &row;
  }
  return nullptr;
}

std::string_view SectionOf(std::string_view parent, std::string_view tag) {
  if (parent == "actuator" || parent == "sensor" || parent == "equality") return parent;
  if (parent == "tendon") return parent;
  if (parent != "default") return tag;
  return std::ranges::find(kActuators, tag) == std::end(kActuators) ? tag : "actuator";
}

std::string VersionText(int header) {
  const int step = header < 1000000 ? 10 : 1000;
  return fmt::format("{}.{}.{}", header / step / step, header / step % step, header % step);
}

}  // namespace mjforge::engine
