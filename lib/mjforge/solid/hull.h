// Convex polyhedra as hulls of points, and faults of shapes.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Dense>

namespace mjforge::solid {

/// Reason why a shape is rejected, and the index of the faulty point; without a point the whole
/// outline is faulty.
struct Fault {
  std::string message;  // end of a sentence about the shape, such as "crosses itself"
  std::optional<std::size_t> point = std::nullopt;
  /// Faulty loop: 0 is the outline, 1 a prism's first hole; holes along z precede holes along x and
  /// y.
  std::size_t loop = 0;
};
/// Sets the fault; returns nullopt.
inline std::nullopt_t Fail(Fault& fault, std::string message,
                           std::optional<std::size_t> point = std::nullopt) {
  fault = {std::move(message), point};
  return std::nullopt;
}

struct Polytope {
  struct Face {
    std::vector<int> corners;  // counter-clockwise from outside
    Eigen::Vector3d normal;    // outward, of length 1
  };
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Face> faces;
};

/// Returns the corners of a box with these half sizes about the origin.
std::array<Eigen::Vector3d, 8> CornersOfBox(const Eigen::Vector3d& half_sizes);

/// Returns the convex hull, computed by Qhull, which merges coplanar facets. The order of faces and
/// vertices depends only on the order of the points. Returns nullopt and sets `fault` if the hull
/// has no volume.
std::optional<Polytope> HullOf(std::span<const Eigen::Vector3d> points, Fault& fault);

}  // namespace mjforge::solid
