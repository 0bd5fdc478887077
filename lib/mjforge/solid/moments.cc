#include "mjforge/solid/moments.h"

#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

namespace mjforge::solid {
namespace {

// An arc of up to a whole turn, and products of up to six sines of it, to 1e-15.
using ArcRule = boost::math::quadrature::gauss<double, 30>;

void AddLine(const Point& from, const Point& to, std::vector<Node>& nodes) {
  const double offset = std::sqrt(0.6) / 2;
  const double positions[] = {0.5 - offset, 0.5, 0.5 + offset};
  constexpr double kWeights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  const Point way = to - from;
  for (int k = 0; k < 3; ++k) nodes.push_back({from + positions[k] * way, kWeights[k] * way.y()});
}

Point AlongArc(const Corner& arc, double share) {
  const double angle = arc.from + share * arc.sweep;
  return arc.place + arc.radius * Point(std::cos(angle), std::sin(angle));
}

void AddArc(const Corner& arc, std::vector<Node>& nodes) {
  const auto add = [&](double x, double weight) {
    const double share = 0.5 + x / 2;
    const double dy = arc.radius * std::cos(arc.from + share * arc.sweep) * arc.sweep;
    nodes.push_back({AlongArc(arc, share), weight / 2 * dy});
  };
  for (std::size_t i = 0; i < ArcRule::abscissa().size(); ++i) {
    for (const double side : {-1, 1}) add(side * ArcRule::abscissa()[i], ArcRule::weights()[i]);
  }
}

/// Integrals of r^a z^b over the area of an outline, for what a turned solid needs.
struct TurnedMoments {
  double r = 0;
  double rr = 0;
  double rz = 0;
  double rrr = 0;
  double rrz = 0;
  double rzz = 0;
};

// By Green's theorem the integral of r^a z^b over the area is that of r^(a+1) z^b / (a+1) dz round
// it. Along a side that is a polynomial of at most degree 5 in the position.
TurnedMoments MomentsOf(std::span<const Node> border, double z0) {
  TurnedMoments sum;
  for (const Node& node : border) {
    const double r = node.p.x();
    const double z = node.p.y() - z0;
    const double dz = node.dy;
    sum.r += r * r / 2 * dz;
    sum.rr += r * r * r / 3 * dz;
    sum.rz += r * r / 2 * z * dz;
    sum.rrr += r * r * r * r / 4 * dz;
    sum.rrz += r * r * r / 3 * z * dz;
    sum.rzz += r * r / 2 * z * z * dz;
  }
  return sum;
}

}  // namespace

std::vector<Node> NodesOf(std::span<const Point> outline) {
  std::vector<Node> nodes;
  nodes.reserve(3 * outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i)
    AddLine(outline[i], outline[(i + 1) % outline.size()], nodes);
  return nodes;
}

std::vector<Node> NodesOf(const std::vector<Corner>& corners) {
  std::vector<Node> nodes;
  const auto ends = [](const Corner& corner) {
    if (corner.radius == 0) return std::pair(corner.place, corner.place);
    return std::pair(AlongArc(corner, 0), AlongArc(corner, 1));
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].radius > 0) AddArc(corners[i], nodes);
    AddLine(ends(corners[i]).second, ends(corners[(i + 1) % corners.size()]).first, nodes);
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

AreaMoments MomentsOf(std::span<const Node> border) {
  AreaMoments sum;
  for (const Node& node : border) {
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

Mass TurnedMass(std::span<const Node> border, double angle) {
  double z0 = 0;  // near the centre: the less cancels
  for (const Node& node : border) z0 += node.p.y() / static_cast<double>(border.size());
  const TurnedMoments m = MomentsOf(border, z0);
  // Integrals of cos, sin, cos^2, sin^2 and sin cos over the angle.
  const bool whole = angle == 2 * std::numbers::pi;
  const double c = whole ? 0 : std::sin(angle);
  const double s = whole ? 0 : 1 - std::cos(angle);
  const double cc = angle / 2 + c * std::cos(angle) / 2;
  const double ss = angle / 2 - c * std::cos(angle) / 2;
  const double cs = c * c / 2;
  Moments moments;
  moments.volume = angle * m.r;
  moments.first = Eigen::Vector3d(m.rr * c, m.rr * s, m.rz * angle);
  moments.second << m.rrr * cc, m.rrr * cs, m.rrz * c,  //
      m.rrr * cs, m.rrr * ss, m.rrz * s,                //
      m.rrz * c, m.rrz * s, m.rzz * angle;
  return MassOf(moments, {0, 0, z0});
}

}  // namespace mjforge::solid
