// Differences between our objects and robosuite's: the element, the correct value, the reason.

#pragma once

#include <span>
#include <string>
#include <string_view>

#include "described.h"

namespace mjforge::parity {

/// A number that is wrong in a reference or a matter of taste.
struct Difference {
  std::string_view reference;
  std::string_view element;  // "geom/body0" means both geoms of the part
  std::string_view field;
  Numbers right;
  std::string_view reason;
};
std::span<const Difference> Differences();
const Difference* FindDifference(std::string_view reference, std::string_view element,
                                 std::string_view field);

/// An element with another name in our objects, in all objects of a class.
struct Renamed {
  std::string_view object_class;
  std::string_view element;
  std::string_view ours;
  std::string_view reason;
};
std::span<const Renamed> RenamedElements();
/// Returns our name of a reference's element ("geom/hole_vis_vis").
std::string OurName(std::string_view object_class, const std::string& element);

/// An element that the reference lacks.
struct Added {
  std::string_view where;  // name of a class or of a reference
  std::string_view element;
  std::string_view reason;
};
std::span<const Added> AddedElements();

}  // namespace mjforge::parity
