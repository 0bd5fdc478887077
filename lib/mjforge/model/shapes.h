// Shapes in the convention of MuJoCo's geoms, and their exact geometry: volume, inertia, bounds,
// support function, point test. To add a shape, see CONTRIBUTING.md, "Adding a part type".

#pragma once

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
/// Returns the value of MJCF's attribute `type`.
std::string_view GeomTypeName(GeomType type);
/// Returns the number of values in MJCF's attribute `size`; 0 for a mesh.
int SizeCount(GeomType type);

/// A shape in its own frame G, centred as MuJoCo centres it. Components of `size`, m, all > 0:
/// sphere (radius), capsule and cylinder (radius, half length of the straight part along z),
/// ellipsoid (three radii), box (three half lengths).
struct Shape {
  GeomType type = GeomType::kSphere;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  const TriangleMesh* mesh = nullptr;  // for kMesh only; a closed surface; not owned
};

/// Mass, centre of mass and inertia of a rigid body in a frame F.
struct MassProperties {
  double mass = 0;                                   // kg
  Eigen::Vector3d p_FCm = Eigen::Vector3d::Zero();   // centre of mass, m
  Eigen::Matrix3d I_Cm_F = Eigen::Matrix3d::Zero();  // about p_FCm, along the axes of F, kg m^2
};

double Volume(const Shape& shape);  // m^3

/// Returns the mass properties in the shape's frame for a uniform density, kg/m^3: closed forms,
/// and for meshes the divergence theorem (Mirtich, "Fast and accurate computation of polyhedral
/// mass properties", 1996; Tonon, 2004).
MassProperties MassOf(const Shape& shape, double density);

/// Returns the mass properties of a thin shell with a mass of 1 kg/m^2.
MassProperties ShellMassOf(const TriangleMesh& mesh);

/// Expresses mass properties in frame A instead of F.
MassProperties InFrame(const Pose& X_AF, const MassProperties& properties_F);
/// Adds the mass properties of two bodies in the same frame (parallel axis theorem).
MassProperties Combine(const MassProperties& a, const MassProperties& b);
/// Multiplies the density of a body by `factor`.
MassProperties Scaled(const MassProperties& properties, double factor);

/// Returns the vertices of a box or a mesh; none for other shapes.
std::vector<Eigen::Vector3d> VerticesOf(const Shape& shape);

/// Support function: the largest dot(direction, point) over the shape. The direction has any
/// length.
double Support(const Shape& shape, const Eigen::Vector3d& direction_G);
/// Returns a point of the shape, in G, at which the support function has its value.
Eigen::Vector3d SupportPoint(const Shape& shape, const Eigen::Vector3d& direction_G);

/// Axis-aligned bounding box, m; empty by default.
struct Box3 {
  Eigen::Vector3d min = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d max = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
  bool empty() const { return min.x() > max.x(); }
  void Add(const Box3& other);
};
/// Returns the exact axis-aligned bounding box of the shape, or of the hull of a solid, at a pose;
/// the box is empty if `extent` has no curves.
Box3 BoundsOf(const Shape& shape, const Pose& X_AG);
Box3 BoundsOf(const solid::Extent& extent, const Pose& X_AS);

/// Returns the largest distance between a point of the shape, or of the hull of a solid, and the z
/// axis of A, m; exact up to rounding.
double HorizontalRadius(const Shape& shape, const Pose& X_AG);
double HorizontalRadius(const solid::Extent& extent, const Pose& X_AS);

/// Returns true if the point is in the shape or on its surface. A mesh may be concave.
bool Contains(const Shape& shape, const Pose& X_AG, const Eigen::Vector3d& p_A);

/// Returns the reason why a mesh has no well-defined inside ("edge shared by 1 triangle", "inside
/// out"); nullopt if the mesh is closed, consistently oriented and of positive volume.
std::optional<std::string> FindSurfaceDefect(const TriangleMesh& mesh);

}  // namespace mjforge::model
