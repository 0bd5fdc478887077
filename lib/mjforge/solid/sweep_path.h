// Path of a tube: lines, arcs at corners, and cubic curves.

#pragma once

#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/solid/solid.h"

namespace mjforge::solid {

/// A line, an arc, or a cubic Hermite curve, for a parameter t from 0 to 1. The tube's radius
/// changes linearly along the segment.
struct PathSegment {
  enum class Type { kLine, kArc, kCubic };
  Type type = Type::kLine;
  Eigen::Vector3d a;   // start; of an arc: centre
  Eigen::Vector3d b;   // end; unused by arcs
  Eigen::Vector3d da;  // derivative at a; of an arc: from the centre to its start
  Eigen::Vector3d db;  // derivative at b; of an arc: from the centre, a quarter turn after `da`
  double angle = 0;    // angle of an arc, rad
  double radius_a = 0;
  double radius_b = 0;
  std::size_t point = 0;  // index of the path's point at the start, or at the arc's corner

  Eigen::Vector3d At(double t) const;
  Eigen::Vector3d Derivative(double t) const;        // with respect to t
  Eigen::Vector3d SecondDerivative(double t) const;  // with respect to t
  double RadiusAt(double t) const { return (1 - t) * radius_a + t * radius_b; }
};

/// Returns the segments of the path; each begins at the end of the previous segment. Directions
/// differ at sharp corners. Returns nullopt and sets `fault` if the path does not make a tube.
std::optional<std::vector<PathSegment>> SweepPathOf(const Tube& tube, Fault& fault);

}  // namespace mjforge::solid
