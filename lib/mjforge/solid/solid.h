#pragma once

// Solids that MuJoCo has no geom for: what is seen of them, the convex pieces that collide in their
// place, and the mass of the true solid. Lengths in m, angles in rad.

#include <array>
#include <cstddef>
#include <list>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Dense>

namespace mjforge::solid {

/// More points than this are refused: outlines are compared edge by edge.
inline constexpr std::size_t kMostPoints = 1000;

/// What is seen: triangles counter-clockwise from outside, with a normal of length 1 and, if it
/// has any, a texture coordinate for each vertex. A vertex on a sharp edge, or where the texture
/// begins and ends, is there once for each side. Between a chord and the true circle there are at
/// most 0.25 mm, and at most 0.5 % of half the shape's size (2 % at the edges of boxes and hulls),
/// unless that takes more than 48 chords.
struct Surface {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3d> normals;
  std::vector<Eigen::Vector2d> texcoords;
  std::vector<std::array<int, 3>> triangles;
  bool in_micrometres = false;  // whether all coordinates of vertices are whole ones
};

/// A convex solid; it collides once for each of the turns about z.
struct Piece {
  enum class Type { kMesh, kSphere, kCapsule, kCylinder, kBox };
  Type type = Type::kMesh;
  /// Of a mesh: closed, its triangles counter-clockwise from outside.
  std::vector<Eigen::Vector3d> vertices = {};
  std::vector<std::array<int, 3>> triangles = {};
  /// Of the others: their size as MuJoCo's geoms have it, and where they stand.
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  std::vector<double> turns = {0};
};

/// Of the true solid, with density 1.
struct Mass {
  double volume = 0;                                  // m^3
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   // m
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the centre, m^5
};

/// Without a look the one piece is seen as it collides, without pieces the look collides.
struct Solid {
  Surface look;
  std::vector<Piece> pieces;
  Mass mass;
};

/// What is wrong with the input, and at which of its points, counted from 0; none: the whole.
struct Fault {
  std::string message;  // "crosses itself", as the end of a sentence
  std::optional<std::size_t> point = std::nullopt;
  std::size_t loop = 0;  // of a prism: 0 its polygon, then its holes
};

/// How a picture is laid on. MuJoCo does not multiply coordinates that a mesh has by `texrepeat`.
struct Texture {
  enum class Unit { kNone, kWhole, kMetre };
  /// What the picture is repeated over: nothing, the surface once around and along it, or a length.
  Unit unit = Unit::kWhole;
  Eigen::Vector2d repeat = Eigen::Vector2d::Ones();  // around, along

  bool operator==(const Texture&) const = default;
};

inline constexpr double kCrease = 40 * std::numbers::pi / 180;

/// A profile in the half plane r >= 0, turned about z, counter-clockwise from the x axis.
struct Lathe {
  std::vector<Eigen::Vector2d> profile;  // r, z: a closed outline, or with `wall` an open line
  /// The thickness, from the line towards the axis.
  std::optional<double> wall = std::nullopt;
  double angle = 2 * std::numbers::pi;  // above 0, up to a whole turn
  /// Sides of the pieces in a whole turn. A piece reaches out of the solid by at most
  /// r (1 / cos(pi / facets) - 1), and into no cavity.
  int facets = 16;
  double crease = kCrease;  // edges with a larger turn are sharp
  Texture texture = {};

  bool operator==(const Lathe&) const = default;
};
std::optional<Solid> Make(const Lathe& lathe, Fault& fault);

/// An outline in x, y with holes, extruded along z, centred on z = 0.
struct Prism {
  std::vector<Eigen::Vector2d> polygon;
  std::vector<std::vector<Eigen::Vector2d>> holes = {};
  double height = 0;
  double round = 0;  // radius of the polygon's corners
  double bevel = 0;  // of all edges at both ends: how far they are cut, along and across
  int facets = 16;   // of rounded corners of the pieces, a whole turn
  double crease = kCrease;
  Texture texture = {};

  bool operator==(const Prism&) const = default;
};
/// The pieces reach nowhere out of the solid. Those of bevelled prisms that are not convex leave
/// the bevelled edges out.
std::optional<Solid> Make(const Prism& prism, Fault& fault);

/// What a disc sweeps that moves along a line, across it.
struct Tube {
  std::vector<Eigen::Vector3d> path = {};
  std::vector<double> radii = {};  // one for each point; between them it changes evenly
  double bend = 0;                 // radius of the arcs in place of the corners; 0: corners
  bool smooth = false;             // a curve through the points
  bool closed = false;             // from the last point back to the first
  /// The thickness of a hollow one; what collides is solid.
  std::optional<double> wall = std::nullopt;
  int facets = 16;  // steps of what collides in a whole turn of an arc
  double crease = kCrease;
  Texture texture = {};

  bool operator==(const Tube&) const = default;
};
/// In an arc of radius R the pieces reach out of the solid by at most R (1 - cos(pi / facets)).
std::optional<Solid> Make(const Tube& tube, Fault& fault);

/// The convex hull of points, and all that is within `round` of it. Without `round` there is only a
/// piece or, with a texture, a look.
struct Hull {
  std::vector<Eigen::Vector3d> points;
  double round = 0;
  Texture texture = {};  // laid on from above, as MuJoCo lays one on a box

  bool operator==(const Hull&) const = default;
};
std::optional<Solid> Make(const Hull& hull, Fault& fault);

/// With rounded edges; one piece, which is not rounded if `piece_is_plain`.
struct RoundedBox {
  Eigen::Vector3d half = Eigen::Vector3d::Zero();  // of the sizes
  double round = 0;                                // less than half the smallest size
  bool piece_is_plain = false;
  Texture texture = {};  // laid on from above, as MuJoCo lays one on a box

  bool operator==(const RoundedBox&) const = default;
};
std::optional<Solid> Make(const RoundedBox& box, Fault& fault);

struct RoundedCylinder {
  double radius = 0;
  double half = 0;   // of the height, along z
  double round = 0;  // less than both
  bool piece_is_plain = false;
  int facets = 16;
  double crease = kCrease;
  Texture texture = {};

  bool operator==(const RoundedCylinder&) const = default;
};
std::optional<Solid> Make(const RoundedCylinder& cylinder, Fault& fault);

using Shape = std::variant<Lathe, Prism, Tube, Hull, RoundedBox, RoundedCylinder>;

/// Makes solids and keeps the last ones: parts that are alike ask for the same one, and so does
/// each mould that is tried for a variant.
class Cache {
 public:
  /// Null after a fault.
  std::shared_ptr<const Solid> Make(const Shape& shape, Fault& fault);

 private:
  struct Entry {
    Shape shape;
    std::shared_ptr<const Solid> solid;
    std::size_t bytes;
  };

  std::list<Entry> entries_;  // the one used last first
  std::size_t bytes_ = 0;
};

}  // namespace mjforge::solid
