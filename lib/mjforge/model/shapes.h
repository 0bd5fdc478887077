// Shapes in the convention of MuJoCo's geoms, and their exact geometry: volume, inertia, bounds,
// support function, point test. To add a shape, see CONTRIBUTING.md, "Adding a part type".

#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/model/poses.h"
#include "mjforge/solid/solid.h"

namespace mjforge::model {

using solid::TriangleMesh;

enum class GeomType { kSphere, kCapsule, kEllipsoid, kCylinder, kBox, kMesh };
/// Values of MJCF's attribute `type`, in the order of GeomType.
inline constexpr std::array<std::string_view, 6> kGeomTypeNames = {
    "sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh"};
/// Returns the value of MJCF's attribute `type` for a geom type.
std::string_view GeomTypeName(GeomType type);
/// Returns the number of values in MJCF's attribute `size` of a geom type; 0 for a mesh.
int SizeCount(GeomType type);

/// A shape in its own frame G, which has the origin and axes of MuJoCo's geom. `size`, in m, as in
/// MJCF: radius of a sphere; radius and half length, along z, of a cylinder or of the straight part
/// of a capsule; three radii of an ellipsoid; three half lengths of a box. All are positive.
struct Shape {
  GeomType type = GeomType::kSphere;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  const TriangleMesh* mesh = nullptr;  // only for kMesh: a closed surface; not owned
};

/// Mass, centre of mass and inertia of a rigid body in a frame F.
struct MassProperties {
  double mass = 0;                                   // kg
  Eigen::Vector3d p_FCm = Eigen::Vector3d::Zero();   // centre of mass, m
  Eigen::Matrix3d I_Cm_F = Eigen::Matrix3d::Zero();  // about p_FCm, along the axes of F, kg m^2
};

/// Returns the mean of a mesh's vertices; zero if there are none.
Eigen::Vector3d MeanVertex(const TriangleMesh& mesh);

/// Returns the volume of a shape, m^3.
double Volume(const Shape& shape);

/// Returns the mass properties in the shape's frame for a uniform density, kg/m^3. Uses a closed
/// form; for meshes, the divergence theorem (Mirtich, "Fast and accurate computation of polyhedral
/// mass properties", 1996; Tonon, 2004).
MassProperties MassOf(const Shape& shape, double density);

/// Returns the mass properties of a mesh as a thin shell with 1 kg/m^2.
MassProperties ShellMassOf(const TriangleMesh& mesh);

/// Returns the mass properties in frame A of a body whose mass properties in frame F are given.
MassProperties InFrame(const Pose& X_AF, const MassProperties& properties_F);
/// Returns the mass properties of two bodies together, all in one frame (parallel axis theorem).
MassProperties Combine(const MassProperties& a, const MassProperties& b);
/// Returns the mass properties of a body after its density is multiplied by `factor`.
MassProperties Scaled(const MassProperties& properties, double factor);

/// Returns the vertices of a box or a mesh; none for other shapes.
std::vector<Eigen::Vector3d> VerticesOf(const Shape& shape);

/// Returns the support function: the largest dot(direction, point) over all points of the shape.
/// The direction may have any length.
double Support(const Shape& shape, const Eigen::Vector3d& direction_G);
/// Returns a point of the shape, in G, at which dot(direction, point) equals the support function.
Eigen::Vector3d SupportPoint(const Shape& shape, const Eigen::Vector3d& direction_G);

/// Axis-aligned bounding box, m; empty by default.
struct Box3 {
  Eigen::Vector3d min = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d max = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
  bool empty() const { return min.x() > max.x(); }
  void Add(const Box3& other);
  Eigen::AlignedBox3d ToEigen() const { return {min, max}; }
};
/// Return the exact axis-aligned bounding box of a shape, or of a solid's convex hull, at a pose.
/// The box is empty if `extent` is an empty hull.
Box3 BoundsOf(const Shape& shape, const Pose& X_AG);
Box3 BoundsOf(const solid::Extent& extent, const Pose& X_AS);

/// Return the largest distance, m, of the points of a shape, or of a solid's convex hull, from the
/// z axis of A; exact up to rounding. Return 0 if `extent` is an empty hull.
double HorizontalRadius(const Shape& shape, const Pose& X_AG);
double HorizontalRadius(const solid::Extent& extent, const Pose& X_AS);

/// Returns true if the point is inside the shape or on its surface. A mesh may be concave.
bool Contains(const Shape& shape, const Pose& X_AG, const Eigen::Vector3d& p_A);

/// Returns the reason why a mesh has no well-defined interior ("edge shared by 1 triangle", "inside
/// out"). Returns nullopt if the mesh is closed, consistently oriented and has a positive volume.
std::optional<std::string> FindSurfaceDefect(const TriangleMesh& mesh);

}  // namespace mjforge::model
