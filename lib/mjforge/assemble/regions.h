// Regions of bodies, and searches for level faces (`type: auto`).

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// A region is level if its angle to the horizontal plane, in rad, is at most this value. At this
/// angle, the ends of an object 30 cm long differ in height by less than 0.1 mm.
inline constexpr double kLevelAngle = 3e-4;
/// Returns a tilt, rad, in words: "tilted by 3.5 degrees at the start".
std::string TiltText(double tilt);

/// A request to find regions on a body: an entry of `regions:` with `type: auto`.
struct FaceSearch {
  std::size_t body = 0;        // index in Object::bodies
  model::Region pattern;       // region with name, site, margin and clear of the entry
  double least_area = 0.0025;  // smallest area, m^2
  double least_height = 0.03;  // smallest free height, m
  /// Elements of the spec that contains the entry: the parts from `first_part` to `last_part` - 1
  /// of the body `root`, and the bodies from `first_body` to `last_body` - 1.
  std::size_t root = 0;
  std::size_t first_part = 0;
  std::size_t last_part = 0;
  std::size_t first_body = 0;
  std::size_t last_body = 0;  // 0: not set yet
};

/// A search for level faces that found no region.
struct EmptySearch {
  std::string region;  // name
  diag::SourceMark mark;
  std::string why_not;
};

/// Moves the origin of a polygonal region's frame to the middle of the polygon's bounding box, and
/// sets Region::half_size. Does nothing for other types of regions.
void CenterOrigin(model::Region& region);

/// Returns true if the region is not empty after a strip of the width `margin` along its edge is
/// removed.
bool HasRoomWithin(const model::Region& region);

/// Adds a region to the body, and a site at the region.
void AddRegionTo(model::Body& body, model::Region region);

/// Searches for level faces, with all joints at their start positions, and adds the found faces as
/// regions. Returns the reason if there are none, otherwise an empty text.
std::string AddFoundRegions(const FaceSearch& search, model::Object& object);

/// Warns about searches that found nothing.
void ReportEmptySearches(const std::vector<EmptySearch>& searches, diag::Findings& findings);

/// Reports regions that are not level at the start. Checks only regions declared in the file of the
/// mark `spec`. Regions of nested specs may be tilted on purpose (a bowl that hangs on a hook).
void CheckLevelRegions(const model::Object& object, diag::SourceMark spec,
                       diag::Findings& findings);

}  // namespace mjforge::assemble
