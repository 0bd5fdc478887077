#include "mjforge/mjcf/targets.h"

#include <algorithm>
#include <array>

#include "mjforge/mjcf/sections.h"

namespace mjforge::mjcf {
namespace {

// robosuite 1.4 and 1.5, robocasa 0.2: models/objects/objects.py of each.
constexpr HostName kRobosuiteNames[] = {
    {"body", "main"},        {"joint", "joint0"},  {"site", "default_site"},
    {"site", "bottom_site"}, {"site", "top_site"}, {"site", "horizontal_radius_site"},
};

// MJX 3.17 (put_model): its enumerations are shorter than MuJoCo's.
constexpr Refusal kMjxRefusals[] = {
    {.section = "sensor", .element = "jointlimitpos"},
    {.section = "sensor", .element = "jointlimitvel"},
    {.section = "sensor", .element = "jointlimitfrc"},
    {.section = "sensor", .element = "tendonlimitpos"},
    {.section = "sensor", .element = "tendonlimitvel"},
    {.section = "sensor", .element = "tendonlimitfrc"},
    {.section = "sensor", .element = "user"},
    {.section = "actuator", .attribute = "body"},  // adhesion, too
    {.section = "actuator", .attribute = "cranksite"},
    {.section = "actuator", .attribute = "dyntype", .word = "user"},
    {.section = "actuator", .attribute = "gaintype", .word = "user"},
    {.section = "actuator", .attribute = "biastype", .word = "user"},
    {.section = "option", .attribute = "integrator", .word = "implicit", .whole = false},
    {.section = "option", .attribute = "solver", .word = "PGS", .whole = false},
    {.section = "option", .element = "flag", .attribute = "energy", .whole = false},
    {.section = "option", .element = "flag", .attribute = "override", .whole = false},
    {.section = "option", .element = "flag", .attribute = "fwdinv", .whole = false},
    {.section = "contact", .element = "pair", .attribute = "margin", .whole = false},
};

constexpr TargetRules kTargets[] = {
    {.target = Target::kMujoco,
     .name = "mujoco",
     .doc = "complete and flat; can be simulated on its own"},
    {.target = Target::kScene,
     .name = "scene",
     .doc = "the same with floor, light and camera; the object rests on the floor",
     .scene = true},
    {.target = Target::kRobosuite,
     .name = "robosuite",
     .doc = "for robosuite's MujocoXMLObject",
     .collision_group = 0,
     .visual_group = 1,
     .own_groups = false,
     .same_look = true,  // it copies collision geoms to look at
     .outer_body = true,
     .prefix = false,
     .root = "object",
     .free_joint = false,
     .twin_suffix = "_visual",
     .host_names = kRobosuiteNames,
     .sections = false,
     .picture_sides = false},
    {.target = Target::kRobocasa,
     .name = "robocasa",
     .doc = "for robocasa's MJCFObject",
     .collision_group = 0,
     .visual_group = 1,
     .own_groups = false,
     .states_mass = true,
     .sphere_sizes = 3,
     .always_assets = true,
     .outer_body = true,
     .region_box = true,
     .prefix = false,
     .root = "object",
     .free_joint = false,
     .region_prefix = "reg_",
     .host_names = kRobosuiteNames,
     .sections = false,
     .picture_sides = false},
    {.target = Target::kMjx,
     .name = "mjx",
     .doc = "for MuJoCo XLA: only shapes that collide with all others there",
     .round_shapes = false,
     .margins = false,
     .refusals = kMjxRefusals},
};

constexpr std::string_view kGroupAttributes[] = {" group=\"0\"", " group=\"1\"", " group=\"2\"",
                                                 " group=\"3\""};

constexpr auto kGroups = [] {
  std::array<GeomGroups, std::size(kTargets)> groups;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    groups[i].collision = kGroupAttributes[kTargets[i].collision_group];
    groups[i].visual = kGroupAttributes[kTargets[i].visual_group];
    groups[i].sphere_sizes = kTargets[i].sphere_sizes;
  }
  return groups;
}();

constexpr bool InOrder() {
  for (std::size_t i = 0; i < std::size(kTargets); ++i) {
    if (static_cast<std::size_t>(kTargets[i].target) != i) return false;
  }
  return true;
}
static_assert(InOrder());

}  // namespace

std::span<const TargetRules> Targets() { return kTargets; }

std::vector<std::string_view> TargetNames() {
  std::vector<std::string_view> names;
  for (const TargetRules& rules : kTargets) names.push_back(rules.name);
  return names;
}

const TargetRules& RulesOf(Target target) { return kTargets[static_cast<std::size_t>(target)]; }

std::optional<Target> FindTarget(std::string_view name) {
  const auto* found = std::ranges::find(kTargets, name, &TargetRules::name);
  if (found == std::end(kTargets)) return std::nullopt;
  return found->target;
}

const GeomGroups& GroupsOf(Target target) { return kGroups[static_cast<std::size_t>(target)]; }

}  // namespace mjforge::mjcf
