#pragma once

// An object as both sides of the comparison see it: named elements with numbers
// and words, MuJoCo's defaults filled in.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mjforge::parity {

using Numbers = std::vector<double>;

struct Element {
  std::map<std::string, Numbers> numbers;    // "size", "pos", "friction", ...
  std::map<std::string, std::string> words;  // "type", "role", "look"
};

/// Elements are keyed "geom/handle", "site/grasp", "joint/joint0", "body/lid",
/// without the object's prefix, and say in which body they are; the root is
/// "body/root". A body has its pose in its parent, mass, com and inertia (xx yy
/// zz xy xz yz about the centre of mass) in its frame. "whole" has mass, com,
/// inertia, aabb_min, aabb_max and horizontal_radius at the joints' zero, and
/// what the object declares: bottom_offset, top_offset, declared_radius.
using Described = std::map<std::string, Element>;

inline constexpr std::string_view kRootBody = "root";

/// "x" of "pot_x" for the prefix "pot_"; other names as they are.
std::string WithoutPrefix(std::string_view name, std::string_view prefix);
/// "geom/wall" of "geom/wall_vis": both geoms of a part.
std::string PartOf(std::string_view element);

/// `given`, with what it leaves out from `defaults`.
Numbers Filled(const Numbers& given, const Numbers& defaults);
/// A unit quaternion whose first component that is not almost 0 is positive.
Numbers Canonical(const Numbers& quaternion);
/// The first numbers of a size, as many as the type uses.
Numbers UsedSize(std::string_view type, const Numbers& size);

inline const Numbers kFriction = {1, 0.005, 0.0001};
inline const Numbers kSolref = {0.02, 1};
inline const Numbers kSolimp = {0.9, 0.95, 0.001, 0.5, 2};
inline const Numbers kGeomColor = {0.5, 0.5, 0.5, 1};

/// Equal to 1e-6 of the largest component; lengths and the like also to 1e-9.
bool Close(std::string_view field, const Numbers& a, const Numbers& b);

}  // namespace mjforge::parity
