// Gauss quadrature on boundaries of areas, and mass moments of solids of revolution.

#include "mjforge/solid/moments.h"

#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

namespace mjforge::solid {
namespace {

// Gauss rule that is accurate to 1e-15 for products of up to six sines along an arc of up to a
// whole turn.
using ArcRule = boost::math::quadrature::gauss<double, kArcNodes>;

void AddLine(const Point2& from, const Point2& to, std::vector<QuadratureNode>& nodes) {
  const double offset = std::sqrt(0.6) / 2;
  const double positions[] = {0.5 - offset, 0.5, 0.5 + offset};
  constexpr double kWeights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  const Point2 side = to - from;
  for (int k = 0; k < 3; ++k) nodes.push_back({from + positions[k] * side, kWeights[k] * side.y()});
}

void AddArc(const RoundedCorner& arc, const ArcDirections& directions,
            std::vector<QuadratureNode>& nodes) {
  for (std::size_t i = 0; i < kArcNodes; ++i) {
    const double dy = arc.radius * directions[i].x() * arc.sweep;
    nodes.push_back({arc.place + arc.radius * directions[i], ArcRule::weights()[i / 2] / 2 * dy});
  }
}

/// Returns the integral of r^a (z - z0)^b over the area of an outline in r, z. By Green's theorem
/// this integral equals the integral of r^(a+1) (z - z0)^b / (a+1) dz along the boundary, whose
/// integrand is a polynomial of degree a + b + 1 along a straight side.
double Integral(std::span<const QuadratureNode> boundary, double z0, int a, int b) {
  double sum = 0;
  for (const QuadratureNode& node : boundary) {
    double value = node.p.x();
    for (int i = 0; i < a; ++i) value *= node.p.x();
    value /= a + 1;
    for (int i = 0; i < b; ++i) value *= node.p.y() - z0;
    sum += value * node.dy;
  }
  return sum;
}

}  // namespace

std::vector<QuadratureNode> NodesOf(std::span<const Point2> outline) {
  std::vector<QuadratureNode> nodes;
  nodes.reserve(3 * outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i)
    AddLine(outline[i], outline[(i + 1) % outline.size()], nodes);
  return nodes;
}

std::vector<ArcDirections> DirectionsOf(const std::vector<RoundedCorner>& corners) {
  std::vector<ArcDirections> all(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].radius == 0) continue;
    const auto at = [&](double share) {
      const double angle = corners[i].from + share * corners[i].sweep;
      return Point2(std::cos(angle), std::sin(angle));
    };
    for (std::size_t k = 0; k < kArcNodes; ++k)
      all[i][k] = at(0.5 + (k % 2 == 0 ? -1 : 1) * ArcRule::abscissa()[k / 2] / 2);
    all[i][kArcNodes] = at(0);
    all[i][kArcNodes + 1] = at(1);
  }
  return all;
}

std::vector<QuadratureNode> NodesOf(const std::vector<RoundedCorner>& corners,
                                    const std::vector<ArcDirections>& directions) {
  std::vector<QuadratureNode> nodes;
  nodes.reserve((kArcNodes + 3) * corners.size());
  const auto end = [&](std::size_t i, std::size_t direction) {
    const RoundedCorner& corner = corners[i];
    if (corner.radius == 0) return corner.place;
    return Point2(corner.place + corner.radius * directions[i][kArcNodes + direction]);
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].radius > 0) AddArc(corners[i], directions[i], nodes);
    AddLine(end(i, 1), end((i + 1) % corners.size(), 0), nodes);
  }
  return nodes;
}

Mass MassOf(const Moments& moments, const Eigen::Vector3d& origin) {
  Mass mass;
  mass.volume = moments.volume;
  const Eigen::Vector3d center = moments.first / mass.volume;
  const Eigen::Matrix3d second = moments.second - mass.volume * center * center.transpose();
  mass.inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
  mass.center = center + origin;
  return mass;
}

AreaMoments MomentsOf(std::span<const QuadratureNode> boundary) {
  AreaMoments sum;
  for (const QuadratureNode& node : boundary) {
    const double x = node.p.x();
    const double y = node.p.y();
    sum.area += x * node.dy;
    sum.first += Eigen::Vector2d(x * x / 2, x * y) * node.dy;
    const double xy = x * x / 2 * y * node.dy;
    sum.second(0, 0) += x * x * x / 3 * node.dy;
    sum.second(0, 1) += xy;
    sum.second(1, 0) += xy;
    sum.second(1, 1) += x * y * y * node.dy;
  }
  return sum;
}

Mass RevolvedMass(std::span<const QuadratureNode> boundary, double angle) {
  double z0 = 0;  // near the centre, to reduce cancellation
  for (const QuadratureNode& node : boundary)
    z0 += node.p.y() / static_cast<double>(boundary.size());
  const auto integral = [&](int a, int b) { return Integral(boundary, z0, a, b); };
  const double rr = integral(2, 0);
  const double rrr = integral(3, 0);
  const double rrz = integral(2, 1);
  // c, s, cc, ss, cs: integrals of cos, sin, cos^2, sin^2 and cos sin over the angle.
  const bool whole = angle == 2 * std::numbers::pi;
  const double c = whole ? 0 : std::sin(angle);
  const double s = whole ? 0 : 1 - std::cos(angle);
  const double cc = angle / 2 + c * std::cos(angle) / 2;
  const double ss = angle / 2 - c * std::cos(angle) / 2;
  const double cs = c * c / 2;
  Moments moments;
  moments.volume = angle * integral(1, 0);
  moments.first = Eigen::Vector3d(rr * c, rr * s, integral(1, 1) * angle);
  moments.second << rrr * cc, rrr * cs, rrz * c,  //
      rrr * cs, rrr * ss, rrz * s,                //
      rrz * c, rrz * s, integral(1, 2) * angle;
  return MassOf(moments, {0, 0, z0});
}

}  // namespace mjforge::solid
