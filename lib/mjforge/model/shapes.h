#pragma once

// Solid shapes with MuJoCo's sizes, and what can be computed of them exactly. To add one:
// CONTRIBUTING.md, "To add a part type".

#include <limits>
#include <span>
#include <string_view>

#include <Eigen/Dense>

#include "mjforge/model/meshes.h"
#include "mjforge/model/poses.h"

namespace mjforge::model {

enum class GeomType { kSphere, kCapsule, kEllipsoid, kCylinder, kBox, kMesh };
std::string_view GeomTypeName(GeomType type);  // MJCF's word
/// How many numbers MJCF's `size` has for it; 0 for a mesh.
int SizeCount(GeomType type);

/// A shape in its own frame G, centred as MuJoCo centres it. size, m: sphere
/// (radius), capsule and cylinder (radius, half length of the straight part
/// along z), ellipsoid (three radii), box (three half lengths); all > 0.
struct Shape {
  GeomType type = GeomType::kSphere;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  const TriangleMesh* mesh = nullptr;  // kMesh only; closed; not owned
};

/// Mass, centre of mass and inertia of a rigid body in a frame F.
struct MassProperties {
  double mass = 0;                                   // kg
  Eigen::Vector3d p_FCm = Eigen::Vector3d::Zero();   // centre of mass, m
  Eigen::Matrix3d I_Cm_F = Eigen::Matrix3d::Zero();  // about it, along F's axes, kg m^2
};

double Volume(const Shape& shape);  // m^3

/// In the shape's frame. Closed forms for solids of uniform density; meshes by
/// the divergence theorem (Mirtich, "Fast and accurate computation of
/// polyhedral mass properties", 1996; Tonon, 2004).
MassProperties MassOf(const Shape& shape, double density);

/// The same body seen from frame A.
MassProperties InFrame(const Pose& X_AF, const MassProperties& properties_F);
/// The two bodies as one (parallel axis theorem).
MassProperties Combine(const MassProperties& a, const MassProperties& b);

/// The same body, `factor` times as dense.
MassProperties Scaled(const MassProperties& properties, double factor);

/// The largest value of dot(direction, point) over the shape; direction of any length.
double Support(const Shape& shape, const Eigen::Vector3d& direction_G);

/// A point of the shape, or of its convex hull, where that value is reached, in G.
Eigen::Vector3d SupportPoint(const Shape& shape, const Eigen::Vector3d& direction_G);

struct Box3 {
  Eigen::Vector3d min = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d max = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
  bool empty() const { return min.x() > max.x(); }
  void Add(const Box3& other);
};
/// Exact axis-aligned box of the shape at a pose.
Box3 BoundsOf(const Shape& shape, const Pose& X_AG);

/// The largest distance of a point of the shape from the z axis of A. Exact up
/// to rounding.
double HorizontalRadius(const Shape& shape, const Pose& X_AG);

/// Is the point in the shape, surface included?
bool Contains(const Shape& shape, const Pose& X_AG, const Eigen::Vector3d& p_A);

}  // namespace mjforge::model
