#pragma once

#include <span>
#include <vector>

#include "mjforge/solid/rounding.h"

namespace mjforge::solid {

/// Where a function is evaluated along the border of an area for its integral over y: the value
/// there counts `dy` times. Exact for polynomials up to degree 5 along lines; along arcs up to
/// rounding.
struct Node {
  Point p;
  double dy = 0;
};
std::vector<Node> NodesOf(std::span<const Point> outline);
std::vector<Node> NodesOf(const std::vector<Corner>& corners);

/// The solid between the half planes at the angles 0 and `angle` that an outline in r, z fills as
/// it turns about z (Pappus and Guldinus, for all moments up to the second).
Mass TurnedMass(std::span<const Node> border, double angle);

/// Of density 1, about the origin.
struct Moments {
  double volume = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // of x x^T
};
/// What has these moments about `origin`.
Mass MassOf(const Moments& moments, const Eigen::Vector3d& origin);

/// Integrals over a plane area of 1, x, y and their products.
struct AreaMoments {
  double area = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
};
AreaMoments MomentsOf(std::span<const Node> border);

}  // namespace mjforge::solid
