// Uniform rotations and directions; colours from hue, saturation and value.

#include <cmath>
#include <numbers>

#include "mjforge/sample/distributions.h"

namespace mjforge::sample {

using std::numbers::pi;

std::array<double, 4> UniformRotation(double u0, double u1, double u2) {
  const double r1 = std::sqrt(1 - u0);
  const double r2 = std::sqrt(u0);
  const double angle1 = 2 * pi * u1;
  const double angle2 = 2 * pi * u2;
  std::array<double, 4> q = {r2 * std::cos(angle2), r1 * std::sin(angle1), r1 * std::cos(angle1),
                             r2 * std::sin(angle2)};
  if (q[0] < 0) {  // q and -q are the same rotation
    for (double& component : q) component = -component;
  }
  return q;
}

std::array<double, 3> UniformDirection(double u0, double u1) {
  const double z = 2 * u0 - 1;
  // Radius of the circle of latitude at height z.
  const double radius = 2 * std::sqrt(u0 * (1 - u0));
  const double angle = 2 * pi * u1;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

std::array<double, 3> HsvToRgb(double h, double s, double v) {
  const double position = h * 6;  // six sectors of the colour circle, starting with red
  const double sector = std::floor(position);
  const double f = position - sector;
  const double p = v * (1 - s);
  const double falling = v * (1 - s * f);
  const double rising = v * (1 - s * (1 - f));
  const std::array<double, 3> colors[] = {{v, rising, p},  {falling, v, p}, {p, v, rising},
                                          {p, falling, v}, {rising, p, v},  {v, p, falling}};
  return colors[static_cast<std::size_t>(sector) % 6];
}

}  // namespace mjforge::sample
