// Solids that MuJoCo has no geom for: render meshes, convex pieces for collisions, exact masses.
// Lengths in m, angles in rad.

#pragma once

#include <array>
#include <cstddef>
#include <list>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/solid/extent.h"
#include "mjforge/solid/hull.h"
#include "mjforge/solid/polygon.h"

namespace mjforge::solid {

/// Maximum number of points of a shape; limited, because outlines are compared edge by edge.
inline constexpr std::size_t kMostPoints = 1000;

/// Triangles, counter-clockwise seen from outside. A vertex on a sharp edge, or where a texture
/// begins and ends, is repeated for each side.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
  std::vector<Eigen::Vector3d> normals = {};    // empty, or one per vertex, of length 1
  std::vector<Eigen::Vector2d> texcoords = {};  // empty, or one per vertex
  bool in_micrometres = false;  // all coordinates of vertices are whole numbers of micrometres
};

/// A convex solid for collisions, repeated at each of the angles `turns` about z.
struct ConvexPiece {
  enum class Type { kMesh, kSphere, kCapsule, kCylinder, kBox };
  Type type = Type::kMesh;
  TriangleMesh mesh = {};  // closed, without normals; empty for other types
  /// Size in the convention of MuJoCo's geoms, and pose; unused for kMesh.
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  std::vector<double> turns = {0};
};

/// Mass properties of the exact solid at density 1.
struct Mass {
  double volume = 0;                                  // m^3
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   // m
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the centre, m^5
};

/// Result of Make(). If the render mesh is empty, the single piece is also rendered; if there are
/// no pieces, the render mesh also collides. The render mesh has normals and, with a texture,
/// texture coordinates. Its chords are within 0.25 mm and 0.5 % of half the shape's size (2 % at
/// the edges of boxes and hulls) of the true circle, unless that takes more than 48 chords.
struct Solid {
  TriangleMesh render_mesh;
  std::vector<ConvexPiece> pieces;
  Mass mass;
  Extent extent = {};  // empty if the vertices of the pieces, or of the render mesh, are exact
};

/// Texture coordinates of a mesh, with all repetitions: MuJoCo ignores `texrepeat` for meshes.
struct TextureMapping {
  enum class Unit { kNone, kWhole, kMetre };
  /// Length over which the picture appears `repeat` times: the whole surface (around and along), or
  /// one metre. With kNone the mesh has no texture coordinates.
  Unit unit = Unit::kWhole;
  Eigen::Vector2d repeat = Eigen::Vector2d::Ones();  // repetitions around and along
  /// True: a picture that is projected from above is turned by 90 degrees, so that its upper edge
  /// is at the lowest x instead of the highest y.
  bool is_turned = false;

  bool operator==(const TextureMapping&) const = default;
};

inline constexpr double kDefaultCrease = 40 * std::numbers::pi / 180;  // default of `crease`, rad

/// A profile in the half plane r >= 0, revolved about z, counter-clockwise from the x axis.
struct Lathe {
  std::vector<Eigen::Vector2d> profile;  // r, z: a closed outline, or with `wall` an open line
  /// Thickness of the wall, from the line towards the axis.
  std::optional<double> wall = std::nullopt;
  double angle = 2 * std::numbers::pi;  // above 0, up to a whole turn
  /// Sides of the pieces in a whole turn. A piece protrudes from the solid by at most
  /// r (1 / cos(pi / facets) - 1), and never into a cavity.
  int facets = 16;
  double crease = kDefaultCrease;  // edges whose faces differ by a larger angle are sharp
  TextureMapping texture = {};

  bool operator==(const Lathe&) const = default;
};
/// Makes a solid. All functions Make return nullopt and set `fault` if the shape is not a solid.
std::optional<Solid> Make(const Lathe& input, Fault& fault);

/// An outline in x, y with holes, extruded along z, centred on z = 0. A prism with holes along x or
/// y has neither rounded corners nor bevels.
struct Prism {
  std::vector<Eigen::Vector2d> polygon;
  std::vector<std::vector<Eigen::Vector2d>> holes = {};    // along z
  std::vector<std::vector<Eigen::Vector2d>> holes_x = {};  // along x: outlines in y, z
  std::vector<std::vector<Eigen::Vector2d>> holes_y = {};  // along y: outlines in x, z
  double height = 0;
  double round = 0;  // radius of the polygon's corners
  double bevel = 0;  // width of the chamfer at all edges of both ends, along z and across
  int facets = 16;   // segments of the pieces' rounded corners in a whole turn
  double crease = kDefaultCrease;
  TextureMapping texture = {};

  bool operator==(const Prism&) const = default;
};
/// Makes a prism. The pieces never protrude. Pieces of a bevelled prism that is not convex omit the
/// bevels. A plain convex prism without a texture is one piece, made by MakeConvexPrism.
std::optional<Solid> Make(const Prism& prism, Fault& fault);

/// Extrudes a convex polygon, given in either direction, along z, centred on z = 0. Repeated
/// corners and corners on straight sides are removed. Returns nullopt if the polygon is not convex
/// or has no area.
std::optional<TriangleMesh> MakeConvexPrism(std::span<const Eigen::Vector2d> polygon,
                                            double height);

/// The volume swept by a disc that moves along a path, perpendicular to the path.
struct Tube {
  std::vector<Eigen::Vector3d> path = {};
  std::vector<double> radii = {};  // radius at each point, interpolated linearly
  double bend = 0;                 // radius of the arcs in place of the corners; 0: sharp corners
  bool smooth = false;             // interpolates the points by a smooth curve
  bool closed = false;             // joins the last point to the first
  /// Thickness of the wall of a hollow tube, whose pieces are not hollow.
  std::optional<double> wall = std::nullopt;
  int facets = 16;  // pieces in a whole turn of an arc
  double crease = kDefaultCrease;
  TextureMapping texture = {};

  bool operator==(const Tube&) const = default;
};
/// Makes a tube. In an arc of radius R the pieces protrude by at most R (1 - cos(pi / facets)).
std::optional<Solid> Make(const Tube& tube, Fault& fault);

/// The convex hull of points, possibly flat, enlarged by the distance `round` (Minkowski sum with a
/// ball). If `round` is 0, there is a single piece or, with a texture, a single render mesh.
struct ConvexHull {
  std::vector<Eigen::Vector3d> points;
  double round = 0;
  TextureMapping texture = {};  // projected from above, as MuJoCo maps a texture to a box

  bool operator==(const ConvexHull&) const = default;
};
std::optional<Solid> Make(const ConvexHull& hull, Fault& fault);

/// A box with rounded edges. Its single piece has sharp edges if `piece_is_plain`.
struct RoundedBox {
  Eigen::Vector3d half = Eigen::Vector3d::Zero();  // half sizes
  double round = 0;                                // less than the smallest half size
  bool piece_is_plain = false;
  TextureMapping texture = {};  // projected from above, as MuJoCo maps a texture to a box

  bool operator==(const RoundedBox&) const = default;
};
std::optional<Solid> Make(const RoundedBox& box, Fault& fault);

/// A cylinder about z with rounded edges. Its single piece has sharp edges if `piece_is_plain`.
struct RoundedCylinder {
  double radius = 0;
  double half = 0;   // half the height
  double round = 0;  // less than `radius` and `half`
  bool piece_is_plain = false;
  int facets = 16;  // sides of the pieces in a whole turn, unless `piece_is_plain`
  double crease = kDefaultCrease;
  TextureMapping texture = {};

  bool operator==(const RoundedCylinder&) const = default;
};
std::optional<Solid> Make(const RoundedCylinder& cylinder, Fault& fault);

using SolidShape = std::variant<Lathe, Prism, Tube, ConvexHull, RoundedBox, RoundedCylinder>;

/// Least recently used cache of equal shapes: at most 64, and 600 kB. Not for several threads.
class Cache {
 public:
  /// Returns the cached or new solid; null, and sets `fault`, if the shape is not a solid.
  std::shared_ptr<const Solid> Make(const SolidShape& shape, Fault& fault);

 private:
  struct Entry {
    SolidShape shape;
    std::shared_ptr<const Solid> solid;
    std::size_t bytes;
  };

  std::list<Entry> entries_;  // most recently used first
  std::size_t bytes_ = 0;
};

}  // namespace mjforge::solid
