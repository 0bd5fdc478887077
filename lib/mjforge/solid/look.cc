#include "mjforge/solid/look.h"

#include <algorithm>
#include <cmath>

namespace mjforge::solid {

void RoundForText(Surface& surface) {
  double size = 0;
  for (const Eigen::Vector3d& p : surface.vertices) size = std::max(size, p.cwiseAbs().maxCoeff());
  if (!(size > 0)) return;
  const auto round = [](auto& vectors, double per_unit) {
    // Dividing gives the double that is nearest to the decimal; adding 0 makes 0 of -0.
    for (auto& v : vectors) v = (v.array() * per_unit).round() / per_unit + 0.0;
  };
  round(surface.vertices, std::pow(10, 6 - std::floor(std::log10(size))));
  round(surface.normals, 1e4);
  round(surface.texcoords, 1e5);
}

}  // namespace mjforge::solid
