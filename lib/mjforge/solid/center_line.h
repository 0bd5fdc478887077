#pragma once

// The line that a tube follows.

#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/solid/solid.h"

namespace mjforge::solid {

/// A straight piece of the line, an arc or a cubic, as Hermite has it: between two points with two
/// derivatives. The tube's radius changes evenly from one end to the other.
struct Span {
  enum class Type { kLine, kArc, kCubic };
  Type type = Type::kLine;
  Eigen::Vector3d a;  // of an arc: its centre
  Eigen::Vector3d b;
  Eigen::Vector3d da;  // of an arc: from the centre to its beginning
  Eigen::Vector3d db;  // of an arc: the same a quarter turn on
  double angle = 0;    // of an arc, rad
  double radius_a = 0;
  double radius_b = 0;
  std::size_t point = 0;  // of the path, where it begins or bends

  Eigen::Vector3d At(double t) const;
  Eigen::Vector3d Derivative(double t) const;        // by t
  Eigen::Vector3d SecondDerivative(double t) const;  // by t
  double RadiusAt(double t) const { return (1 - t) * radius_a + t * radius_b; }
};

/// The spans, each where the one before it ends; at corners of the path they are in other
/// directions. Nothing, and a fault, for a tube that cannot be.
std::optional<std::vector<Span>> CenterLineOf(const Tube& tube, Fault& fault);

}  // namespace mjforge::solid
