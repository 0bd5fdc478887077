// Regions as they are added to bodies, and searches for level faces.

#pragma once

#include <cstddef>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Largest angle of a region to the horizontal, rad: one end of an object 30 cm long is less than
/// 0.1 mm higher than the other.
inline constexpr double kLevelAngle = 3e-4;

/// A request to find regions on a body: `type: auto`.
struct FaceSearch {
  std::size_t body = 0;        // index in Object::bodies
  model::Region pattern;       // name, site, margin and clear of the first region
  double least_area = 0.0025;  // m^2
  double least_height = 0.03;  // free height, m
  /// Extent of the spec that has the request: the parts of its root body, and its other bodies.
  std::size_t root = 0;
  std::size_t first_part = 0;
  std::size_t last_part = 0;
  std::size_t first_body = 0;
  std::size_t last_body = 0;  // 0: not known yet
};

/// Moves the origin of a polygon to the middle of its bounding box, and sets its half sizes.
void CenterOrigin(model::Region& region);

/// Returns true if the margin leaves some of the region.
bool HasRoomWithin(const model::Region& region);

/// Adds a region and its site.
void AddRegionTo(model::Body& body, model::Region region);

/// Finds the level faces of one search, at the start state, and adds them as regions.
void AddFoundRegions(const FaceSearch& search, model::Object& object);

/// Reports the regions declared in the file of `spec` that are not level at the start. Ignores the
/// regions of nested specs, which may be tilted on purpose, like a bowl that hangs on a hook.
void CheckLevelRegions(const model::Object& object, diag::SourceMark spec,
                       diag::Findings& findings);

}  // namespace mjforge::assemble
