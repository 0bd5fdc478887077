// Description of an object for comparison: named elements with numbers and words, including
// MuJoCo's defaults.

#pragma once

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

/// Elements by key: "geom/handle", "site/grasp", "joint/joint0", "body/lid", without the object's
/// prefix. The word "body" is the element's body; the root is "body/root". A body has its pose in
/// its parent, and mass, com and inertia (xx yy zz xy xz yz about the centre of mass) in its frame.
/// "whole" has mass, com, inertia, aabb_min, aabb_max and horizontal_radius with all joints at
/// zero, and the object's declared bottom_offset, top_offset and declared_radius.
using Described = std::map<std::string, Element>;

inline constexpr std::string_view kRootBody = "root";

/// Removes the prefix: "pot_x" becomes "x" for the prefix "pot_". Other names are unchanged.
std::string WithoutPrefix(std::string_view name, std::string_view prefix);
/// Returns the part of a geom: "geom/wall" for "geom/wall_vis".
std::string PartOf(std::string_view element);

/// Returns `given`, completed by the numbers of `defaults` that it lacks.
Numbers Filled(const Numbers& given, const Numbers& defaults);
/// Returns the unit quaternion with a positive first component (ignoring those near 0).
Numbers Canonical(const Numbers& quaternion);
/// Returns the numbers of a size that the geom type uses.
Numbers UsedSize(std::string_view type, const Numbers& size);

inline const Numbers kFriction = {1, 0.005, 0.0001};
inline const Numbers kSolref = {0.02, 1};
inline const Numbers kSolimp = {0.9, 0.95, 0.001, 0.5, 2};
inline const Numbers kGeomColor = {0.5, 0.5, 0.5, 1};

/// Returns true if the numbers are equal up to 1e-6 of the largest component or, for lengths and
/// similar fields, up to 1e-9.
bool Close(std::string_view field, const Numbers& a, const Numbers& b);

}  // namespace mjforge::parity
