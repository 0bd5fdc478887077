#pragma once

// Solids that MuJoCo has no geom for: what is seen of them, the convex pieces that collide in their
// place, and the mass of the true solid. Lengths in m, angles in rad.

#include <array>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Dense>

namespace mjforge::solid {

/// More points than this are refused: outlines are compared edge by edge.
inline constexpr std::size_t kMostPoints = 1000;

/// What is seen: triangles counter-clockwise from outside, with a normal of length 1 and, if it
/// has any, a texture coordinate for each vertex. A vertex on a sharp edge, or where the texture
/// begins and ends, is there once for each side.
struct Surface {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3d> normals;
  std::vector<Eigen::Vector2d> texcoords;
  std::vector<std::array<int, 3>> triangles;
};

/// A convex polyhedron, closed, its triangles counter-clockwise from outside; it collides once for
/// each of the turns about z.
struct Piece {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> turns;
};

/// Of the true solid, with density 1.
struct Mass {
  double volume = 0;                                  // m^3
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   // m
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the centre, m^5
};

struct Solid {
  Surface look;
  std::vector<Piece> pieces;
  Mass mass;
};

/// What is wrong with the input, and at which of its points, counted from 0; none: the whole.
struct Fault {
  std::string message;  // "crosses itself", as the end of a sentence
  std::optional<std::size_t> point;
};

/// How a picture is laid on. MuJoCo does not multiply coordinates that a mesh has by `texrepeat`.
struct Texture {
  enum class Unit { kNone, kWhole, kMetre };
  /// What the picture is repeated over: nothing, the surface once around and along it, or a length.
  Unit unit = Unit::kWhole;
  Eigen::Vector2d repeat = Eigen::Vector2d::Ones();  // around, along
};

/// A profile in the half plane r >= 0, turned about z, counter-clockwise from the x axis.
struct Lathe {
  std::vector<Eigen::Vector2d> profile;  // r, z: a closed outline, or with `wall` an open line
  /// The thickness, from the line towards the axis.
  std::optional<double> wall = std::nullopt;
  double angle = 2 * std::numbers::pi;  // above 0, up to a whole turn
  /// Sides of the pieces in a whole turn. A piece reaches out of the solid by at most
  /// r (1 / cos(pi / facets) - 1), and into no cavity.
  int facets = 16;
  double crease = 40 * std::numbers::pi / 180;  // edges with a larger turn are sharp
  Texture texture = {};
};
std::optional<Solid> Make(const Lathe& lathe, Fault& fault);

}  // namespace mjforge::solid
