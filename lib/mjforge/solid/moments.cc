#include "mjforge/solid/moments.h"

#include <cmath>
#include <numbers>

namespace mjforge::solid {
namespace {

/// Integrals of r^a z^b over the area of an outline, for what a turned solid needs.
struct Moments {
  double r = 0;
  double rr = 0;
  double rz = 0;
  double rrr = 0;
  double rrz = 0;
  double rzz = 0;
};

// By Green's theorem the integral of r^a z^b over the area is that of r^(a+1) z^b / (a+1) dz round
// it. Along a side that is a polynomial of at most degree 5 in the position: three points of Gauss
// and Legendre are exact.
Moments MomentsOf(std::span<const Point> outline, double z0) {
  const double offset = std::sqrt(0.6) / 2;
  const double positions[] = {0.5 - offset, 0.5, 0.5 + offset};
  constexpr double kWeights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  Moments sum;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& from = outline[i];
    const Point way = outline[(i + 1) % outline.size()] - from;
    for (int k = 0; k < 3; ++k) {
      const Point p = from + positions[k] * way;
      const double r = p.x();
      const double z = p.y() - z0;
      const double dz = kWeights[k] * way.y();
      sum.r += r * r / 2 * dz;
      sum.rr += r * r * r / 3 * dz;
      sum.rz += r * r / 2 * z * dz;
      sum.rrr += r * r * r * r / 4 * dz;
      sum.rrz += r * r * r / 3 * z * dz;
      sum.rzz += r * r / 2 * z * z * dz;
    }
  }
  return sum;
}

}  // namespace

Mass TurnedMass(std::span<const Point> outline, double angle) {
  double z0 = 0;  // near the centre: the less cancels
  for (const Point& corner : outline) z0 += corner.y() / static_cast<double>(outline.size());
  const Moments m = MomentsOf(outline, z0);
  // Integrals of cos, sin, cos^2, sin^2 and sin cos over the angle.
  const bool whole = angle == 2 * std::numbers::pi;
  const double c = whole ? 0 : std::sin(angle);
  const double s = whole ? 0 : 1 - std::cos(angle);
  const double cc = angle / 2 + c * std::cos(angle) / 2;
  const double ss = angle / 2 - c * std::cos(angle) / 2;
  const double cs = c * c / 2;
  Mass mass;
  mass.volume = angle * m.r;
  const Eigen::Vector3d center = Eigen::Vector3d(m.rr * c, m.rr * s, m.rz * angle) / mass.volume;
  Eigen::Matrix3d second;
  second << m.rrr * cc, m.rrr * cs, m.rrz * c,  //
      m.rrr * cs, m.rrr * ss, m.rrz * s,        //
      m.rrz * c, m.rrz * s, m.rzz * angle;
  second -= mass.volume * center * center.transpose();
  mass.inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
  mass.center = center + Eigen::Vector3d(0, 0, z0);
  return mass;
}

}  // namespace mjforge::solid
