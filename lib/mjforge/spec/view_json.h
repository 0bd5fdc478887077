// The view of a spec in pictures, as JSON.
#pragma once

#include <string>

namespace mjforge::spec {

struct PictureView;

/// Returns an object with the members `azimuth` and `elevation`, in degrees, as far as the view has
/// them, and `pose`: an object of joints and their positions, rad or m.
std::string ViewJson(const PictureView& view);

}  // namespace mjforge::spec
