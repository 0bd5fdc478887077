#include "differences.h"

#include <algorithm>

namespace mjforge::parity {
namespace {

constexpr std::string_view kMargin =
    "a contact margin of 1 mm, which robosuite gives to cylinders only, holds them that far above "
    "what they lie on; ours touch";
constexpr std::string_view kWalls =
    "walls along x are as long as the pot in x, walls along y as in y; robosuite takes the other "
    "size, which is right for square pots only";
constexpr std::string_view kWallsWhole =
    "follows from the walls; by the sum of the boxes' inertias, parallel axes";
constexpr std::string_view kSolid =
    "a solid handle of length l begins at the wall: its middle is l / 2 from it; robosuite's "
    "floats "
    "at l";
constexpr std::string_view kSolidWhole = "follows from the handles";
constexpr std::string_view kMount =
    "the site is where the mount is; robosuite leaves it at the middle when the mount moves";

const Difference kDifferences[] = {
    {"cylinder_explicit", "geom/g0", "margin", {0}, kMargin},
    {"cylinder_slide_hinge", "geom/g0", "margin", {0}, kMargin},

    // Half sizes 0.09 x 0.05 x 0.06, walls 0.008 thick: 0 and 2 along x, 1 and 3 along y.
    {"pot_rectangular", "geom/body0", "size", {0.004, 0.09, 0.06}, kWalls},
    {"pot_rectangular", "geom/body1", "size", {0.004, 0.05, 0.06}, kWalls},
    {"pot_rectangular", "geom/body2", "size", {0.004, 0.09, 0.06}, kWalls},
    {"pot_rectangular", "geom/body3", "size", {0.004, 0.05, 0.06}, kWalls},
    {"pot_rectangular",
     "whole",
     "inertia",
     {0.0018180112990858852, 0.0024822882910858846, 0.0027063764992, 0, 0, 0},
     kWallsWhole},
    // The corner of a grip: half width 0.03 + 0.008, reach 0.05 + 0.05 + 0.008.
    {"pot_rectangular", "whole", "horizontal_radius", {0.1144901742508937}, kWallsWhole},

    // The wall is at 0.07, the handle 0.09 long and 0.09 wide.
    {"pot_solid_handles", "geom/handle0", "pos", {0, 0.115, 0.06}, kSolid},
    {"pot_solid_handles", "geom/handle1", "pos", {0, -0.115, 0.06}, kSolid},
    {"pot_solid_handles",
     "whole",
     "inertia",
     {0.010376508486707568, 0.0060916084867075684, 0.009962033333333335, 0, 0, 0},
     kSolidWhole},
    {"pot_solid_handles", "whole", "aabb_min", {-0.07, -0.16, -0.07}, kSolidWhole},
    {"pot_solid_handles", "whole", "aabb_max", {0.07, 0.16, 0.07}, kSolidWhole},
    {"pot_solid_handles", "whole", "horizontal_radius", {0.16620770138594662}, kSolidWhole},

    {"stand_mount_offset", "site/mount_site", "pos", {0.05, -0.03, 0.06}, kMount},
};

constexpr std::string_view kSigns = "names are made of letters, digits and underscores";

constexpr Renamed kRenamed[] = {
    {"PotWithHandlesObject", "geom/handle0_-", "geom/handle0_arm0", kSigns},
    {"PotWithHandlesObject", "geom/handle0_+", "geom/handle0_arm1", kSigns},
    {"PotWithHandlesObject", "geom/handle1_-", "geom/handle1_arm0", kSigns},
    {"PotWithHandlesObject", "geom/handle1_+", "geom/handle1_arm1", kSigns},
    {"StandWithMount", "geom/hole_vis", "geom/hole",
     "the name of a visual geom ends in _vis of itself; once is enough"},
};

constexpr std::string_view kGrasp = "where a gripper takes the object";

constexpr Added kAdded[] = {
    {"HammerObject", "site/grasp", kGrasp},
    {"HammerObject", "site/strike", "the middle of the face, z along the blow"},
    {"Lid", "site/grasp", kGrasp},
};

}  // namespace

std::span<const Difference> Differences() { return kDifferences; }
std::span<const Renamed> RenamedElements() { return kRenamed; }
std::span<const Added> AddedElements() { return kAdded; }

const Difference* FindDifference(std::string_view reference, std::string_view element,
                                 std::string_view field) {
  const auto found = std::ranges::find_if(kDifferences, [&](const Difference& difference) {
    return difference.reference == reference && difference.element == PartOf(element) &&
           difference.field == field;
  });
  return found == std::end(kDifferences) ? nullptr : &*found;
}

std::string OurName(std::string_view object_class, const std::string& element) {
  const std::string part = PartOf(element);
  for (const Renamed& renamed : kRenamed) {
    if (renamed.object_class == object_class && renamed.element == part) {
      return std::string(renamed.ours) + element.substr(part.size());
    }
  }
  return element;
}

bool IsAdded(std::string_view object_class, std::string_view element) {
  return std::ranges::any_of(kAdded, [&](const Added& added) {
    return added.object_class == object_class && added.element == element;
  });
}

}  // namespace mjforge::parity
