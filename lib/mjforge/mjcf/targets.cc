#include "mjforge/mjcf/sections.h"

#include <algorithm>
#include <array>

namespace mjforge::mjcf {
namespace {

constexpr TargetInfo kTargets[] = {
    {Target::kMujoco, "mujoco", "complete and flat, simulates by itself"},
    {Target::kScene, "scene",
     "the same with floor, light and camera; the object rests on the floor"},
};

// One row a target, in the order of the enumeration.
constexpr GeomGroups kGroups[] = {
    {.collision = " group=\"3\"", .visual = " group=\"2\""},  // MuJoCo's viewer hides group 3
    {.collision = " group=\"3\"", .visual = " group=\"2\""},
};
static_assert(std::size(kGroups) == std::size(kTargets));

}  // namespace

std::span<const TargetInfo> Targets() { return kTargets; }

std::optional<Target> FindTarget(std::string_view name) {
  const auto* found = std::ranges::find(kTargets, name, &TargetInfo::name);
  if (found == std::end(kTargets)) return std::nullopt;
  return found->target;
}

const GeomGroups& GroupsOf(Target target) { return kGroups[static_cast<int>(target)]; }

}  // namespace mjforge::mjcf
