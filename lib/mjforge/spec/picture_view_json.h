// JSON text of `view:`: camera direction and joint positions for pictures of a spec.
#pragma once

#include <string>

namespace mjforge::spec {

struct PictureView;

/// Returns a JSON object with `azimuth` and `elevation` in degrees, if the view has them, and
/// `pose`, an object with the position of each joint in rad or m.
std::string ViewJson(const PictureView& view);

}  // namespace mjforge::spec
