// Table of targets: robosuite, robocasa, MuJoCo XLA and MuJoCo itself.

#include "mjforge/mjcf/targets.h"

#include <algorithm>
#include <cstddef>

#include "mjforge/diag/diag.h"

namespace mjforge::mjcf {
namespace {

// Names of elements that robosuite and robocasa add to each object. Source:
// models/objects/objects.py of robosuite 1.4 and 1.5, and of robocasa 0.2.
constexpr HostName kRobosuiteNames[] = {
    {"body", "main"},        {"joint", "joint0"},  {"site", "default_site"},
    {"site", "bottom_site"}, {"site", "top_site"}, {"site", "horizontal_radius_site"},
};

// Elements and values that MuJoCo has but MJX lacks. Source: put_model of MJX 3.17.
constexpr UnsupportedFeature kMjxUnsupported[] = {
    {.section = "sensor", .element = "jointlimitpos"},
    {.section = "sensor", .element = "jointlimitvel"},
    {.section = "sensor", .element = "jointlimitfrc"},
    {.section = "sensor", .element = "tendonlimitpos"},
    {.section = "sensor", .element = "tendonlimitvel"},
    {.section = "sensor", .element = "tendonlimitfrc"},
    {.section = "sensor", .element = "user"},
    {.section = "actuator", .attribute = "body"},  // includes adhesion actuators
    {.section = "actuator", .attribute = "cranksite"},
    {.section = "actuator", .attribute = "dyntype", .text = "user"},
    {.section = "actuator", .attribute = "gaintype", .text = "user"},
    {.section = "actuator", .attribute = "biastype", .text = "user"},
    {.section = "option", .attribute = "integrator", .text = "implicit", .drops_element = false},
    {.section = "option", .attribute = "solver", .text = "PGS", .drops_element = false},
    {.section = "option", .attribute = "noslip_iterations", .drops_element = false},  // no effect
    {.section = "option", .element = "flag", .attribute = "energy", .drops_element = false},
    {.section = "option", .element = "flag", .attribute = "override", .drops_element = false},
    {.section = "option", .element = "flag", .attribute = "fwdinv", .drops_element = false},
    {.section = "contact", .element = "pair", .attribute = "margin", .drops_element = false},
};

constexpr TargetRules kTargets[] = {
    {.target = Target::kMujoco,
     .name = "mujoco",
     .doc = "complete and flat; can be simulated on its own",
     .repeats_start = true},  // mjlab sets joints to 0 unless the file has a keyframe
    {.target = Target::kScene,
     .name = "scene",
     .doc = "the same with floor, light and camera; the object rests on the floor",
     .has_scene = true},
    {.target = Target::kRobosuite,
     .name = "robosuite",
     .doc = "for robosuite's MujocoXMLObject",
     .collision_group = 0,
     .visual_group = 1,
     .keeps_groups = false,
     .shows_collision_copies = true,
     .has_outer_body = true,
     .has_prefix = false,
     .root = "object",
     .has_free_joint = false,
     .visual_copy_suffix = "_visual",
     .host_names = kRobosuiteNames,
     .supports_sections = false,
     .supports_texture_sides = false},
    {.target = Target::kRobocasa,
     .name = "robocasa",
     .doc = "for robocasa's MJCFObject",
     .collision_group = 0,
     .visual_group = 1,
     .keeps_groups = false,
     .writes_mass = true,
     .sphere_sizes = 3,
     .always_has_assets = true,
     .has_outer_body = true,
     .has_region_geoms = true,
     .has_prefix = false,
     .root = "object",
     .has_free_joint = false,
     .region_prefix = "reg_",
     .host_names = kRobosuiteNames,
     .file_in_folder = "model.xml",
     .supports_sections = false,
     .supports_texture_sides = false},
    {.target = Target::kMjx,
     .name = "mjx",
     .doc = "for MuJoCo XLA: only shapes that collide with all others there",
     .supports_round_shapes = false,
     .supports_margins = false,
     .unsupported = kMjxUnsupported},
};

static_assert(std::ranges::all_of(kTargets, [](const TargetRules& rules) {
  return &rules - kTargets == static_cast<std::ptrdiff_t>(rules.target);
}));

}  // namespace

std::span<const TargetRules> Targets() { return kTargets; }

std::vector<std::string_view> TargetNames() {
  return diag::Mapped<std::string_view>(kTargets, &TargetRules::name);
}

const TargetRules& RulesOf(Target target) { return kTargets[static_cast<std::size_t>(target)]; }

std::optional<Target> FindTarget(std::string_view name) {
  const auto* found = std::ranges::find(kTargets, name, &TargetRules::name);
  if (found == std::end(kTargets)) return std::nullopt;
  return found->target;
}

}  // namespace mjforge::mjcf
