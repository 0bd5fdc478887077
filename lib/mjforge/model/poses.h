#pragma once

// Rigid poses and the ways MJCF writes an orientation.

#include <Eigen/Dense>

namespace mjforge::model {

/// Pose of a frame B in a frame A, X_AB: a point p_B is p_A = q * p_B + p.
struct Pose {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();            // m
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();  // unit

  /// X_AC = X_AB * X_BC.
  Pose operator*(const Pose& X_BC) const;
  Eigen::Vector3d operator*(const Eigen::Vector3d& p_B) const { return q * p_B + p; }
  Pose Inverse() const { return {q.conjugate() * -p, q.conjugate()}; }
};

/// The numbers of MJCF's `quat`: w x y z.
inline Eigen::Vector4d Wxyz(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }
/// Angles about the moving x, y and z axes in turn (MuJoCo's eulerseq "xyz"), rad.
Eigen::Quaterniond FromEuler(const Eigen::Vector3d& angles);
/// Rotation by `angle` (rad) about `axis` (not zero; any length).
Eigen::Quaterniond FromAxisAngle(const Eigen::Vector3d& axis, double angle);
/// The frame whose x axis is along `x` and whose y axis is in the plane of x
/// and y, as MuJoCo's xyaxes. Not parallel, not zero.
Eigen::Quaterniond FromXyAxes(const Eigen::Vector3d& x, const Eigen::Vector3d& y);
/// The smallest rotation that takes +z to `z` (not zero), as MuJoCo's zaxis.
Eigen::Quaterniond FromZAxis(const Eigen::Vector3d& z);

}  // namespace mjforge::model
