#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjforge/solid/sweep.h"

namespace mjforge::solid {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

void AddStations(const Span& span, int per_turn, std::vector<Station>& stations) {
  const double turn = span.type == Span::Type::kArc     ? span.angle / (2 * std::numbers::pi)
                      : span.type == Span::Type::kCubic ? 0.25
                                                        : 0;
  const int steps = std::max(1, static_cast<int>(std::ceil(turn * per_turn - 1e-9)));
  const double start = stations.empty() ? 0 : stations.back().along;
  double along = start;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Vector3d d = span.Derivative(t);
    const Vector3d p = span.At(t);
    if (i > 0) along += (p - stations.back().p).norm();
    stations.push_back({.p = p,
                        .way = d.normalized(),
                        .x = Vector3d::Zero(),
                        .cut = d.normalized(),
                        .radius = span.RadiusAt(t),
                        .slope = (span.radius_b - span.radius_a) / d.norm(),
                        .along = along});
  }
}

void SetCut(Station& end, Station& start) {
  end.cut = start.cut = (end.way + start.way).normalized();
}

}  // namespace

std::vector<Station> StationsOf(const std::vector<Span>& spans, bool closed, int per_turn) {
  std::vector<Station> stations;
  for (const Span& span : spans) {
    const std::size_t before = stations.size();
    AddStations(span, per_turn, stations);
    if (before > 0) SetCut(stations[before - 1], stations[before]);
  }
  if (closed) SetCut(stations.back(), stations.front());
  const Vector3d& way = stations.front().way;
  Eigen::Index least = 0;
  way.cwiseAbs().minCoeff(&least);
  stations.front().x = way.cross(Vector3d::Unit(least)).normalized();
  for (std::size_t i = 1; i < stations.size(); ++i) {
    const Quaterniond turn = Quaterniond::FromTwoVectors(stations[i - 1].way, stations[i].way);
    const Vector3d x = turn * stations[i - 1].x;
    stations[i].x = (x - x.dot(stations[i].way) * stations[i].way).normalized();
  }
  if (!closed) return stations;
  const Quaterniond turn = Quaterniond::FromTwoVectors(stations.back().way, way);
  const Vector3d end = turn * stations.back().x;
  const Vector3d& x = stations.front().x;
  const double missing = std::atan2(end.cross(x).dot(way), end.dot(x));
  for (Station& station : stations) {
    const double angle = missing * station.along / stations.back().along;
    station.x = Eigen::AngleAxisd(angle, station.way) * station.x;
  }
  return stations;
}

}  // namespace mjforge::solid
