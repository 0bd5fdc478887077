// Table of the differences between our objects and robosuite's, with reasons.

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
constexpr std::string_view kCorner =
    "0.04 above the corner of the whole; robosuite takes the corner away again for a child of a "
    "child, which puts the box into the one it stands on";
constexpr std::string_view kCornerWhole =
    "follows from the upper box; by the sum of the boxes' inertias, parallel axes";
constexpr std::string_view kTotalSize =
    "total_size is what the object declares, above as below; robosuite does not use it for top and "
    "bottom, where 0 is always inside";
constexpr std::string_view kPin =
    "the pin lies along y, so it is as long as the narrower box is in y; robosuite takes x";
constexpr std::string_view kTurned =
    "exact; robosuite adds up offsets and extents as if nothing were turned";
constexpr std::string_view kRadius =
    "exact; robosuite adds the child's own declared radius, which is too large, to the larger of x "
    "and y";
constexpr std::string_view kNegative =
    "exact; robosuite takes the larger of x and y with their signs, so that what is on the "
    "negative "
    "side does not count";

const Difference kDifferences[] = {
    {"cylinder_explicit", "geom/g0", "margin", {0}, kMargin},
    {"cylinder_slide_hinge", "geom/g0", "margin", {0}, kMargin},
    {"cbody_corner_total_size", "geom/pin_g0", "margin", {0}, kMargin},
    {"cbody_hollow_ends", "geom/axle_g0", "margin", {0}, kMargin},

    // The lower box spans z = -0.1 to -0.06, the upper one -0.06 to 0.
    {"cbody_corner_nested", "body/upper", "pos", {-0.06, -0.06, 0.05}, kCorner},
    {"cbody_corner_nested", "whole", "aabb_min", {-0.1, -0.1, -0.1}, kCornerWhole},
    {"cbody_corner_nested", "whole", "aabb_max", {0.1, 0.1, 0}, kCornerWhole},
    {"cbody_corner_nested",
     "whole",
     "com",
     {-0.01161290322580645, -0.01161290322580645, -0.0703225806451613},
     kCornerWhole},
    {"cbody_corner_nested",
     "whole",
     "inertia",
     {0.007755698924731184, 0.007755698924731184, 0.013305944086021506, -0.0011148387096774192,
      0.0009290322580645161, 0.0009290322580645161},
     kCornerWhole},
    {"cbody_corner_nested", "whole", "bottom_offset", {-0.1}, kTotalSize},
    {"cbody_corner_nested", "whole", "top_offset", {0.1}, kTotalSize},
    {"cbody_corner_total_size", "whole", "top_offset", {0.06}, kTotalSize},

    {"cbody_hollow_ends", "whole", "declared_radius", {0.03}, kRadius},
    // The ball of radius 0.03 is at x = -0.25; the capsule lies along y at z = -0.1.
    {"cbody_negative_offsets", "whole", "declared_radius", {0.28}, kNegative},
    {"cbody_negative_offsets", "whole", "bottom_offset", {-0.11}, kTurned},
    // The branch leaves the stem's end at z = 0.2 along x: its leaf ends at 0.1 + 0.02.
    {"cbody_rotated_parents", "whole", "declared_radius", {0.12}, kTurned},
    {"cbody_rotated_parents", "whole", "top_offset", {0.22}, kTurned},

    // The lower box ends at z = -0.02, the lid at 0.02 + 2 * 0.01, a corner of it at (0.06, 0.04).
    {"hinged_rect_rgba", "geom/hinge_g0", "size", {0.002, 0.03}, kPin},
    {"hinged_rect_rgba", "whole", "bottom_offset", {-0.02}, kTurned},
    {"hinged_rect_rgba", "whole", "top_offset", {0.04}, kTurned},
    {"hinged_rect_rgba", "whole", "declared_radius", {0.07211102550927977}, kRadius},

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

constexpr std::string_view kRegion = "where other objects can stand";

constexpr Added kAdded[] = {
    {"Bin", "site/inside", kRegion},
    {"HammerObject", "site/grasp", kGrasp},
    {"HammerObject", "site/strike", "the middle of the face, z along the blow"},
    {"HingedBoxObject", "site/grasp", kGrasp},
    {"HingedBoxObject", "site/box2_surface", kRegion},
    {"Lid", "site/grasp", kGrasp},
    {"PotWithHandlesObject", "site/grasp0", kGrasp},
    {"PotWithHandlesObject", "site/grasp1", kGrasp},
    {"PotWithHandlesObject", "site/inside", kRegion},
    {"cbody_of_composites", "site/bin_inside", kRegion},
    {"cbody_of_composites", "site/chest_box2_surface", kRegion},
    {"cbody_of_composites", "site/chest_grasp", kGrasp},
    {"cbody_of_composites", "site/hammer_grasp", kGrasp},
    {"cbody_of_composites", "site/hammer_strike", "as the hammer's"},
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

}  // namespace mjforge::parity
