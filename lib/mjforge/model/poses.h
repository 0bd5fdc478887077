// Rigid poses, and the orientations of MJCF (quat, euler, axisangle, xyaxes, zaxis).

#pragma once

#include <Eigen/Dense>

namespace mjforge::model {

/// Pose X_AB of a frame B in a frame A. The coordinates of a point are p_A = q * p_B + p.
struct Pose {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();            // m
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();  // unit

  /// Returns X_AC = X_AB * X_BC.
  Pose operator*(const Pose& X_BC) const;
  Eigen::Vector3d operator*(const Eigen::Vector3d& p_B) const { return q * p_B + p; }
  Pose Inverse() const { return {q.conjugate() * -p, q.conjugate()}; }
};

/// Returns the numbers of MJCF's `quat` in the order w, x, y, z.
inline Eigen::Vector4d Wxyz(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }
/// Returns the rotation by three angles, rad, about the moving x, y and z axes in this order
/// (MuJoCo's eulerseq "xyz").
Eigen::Quaterniond FromEuler(const Eigen::Vector3d& angles);
/// Returns the rotation by `angle`, rad, about `axis`, which may have any length but 0.
Eigen::Quaterniond FromAxisAngle(const Eigen::Vector3d& axis, double angle);
/// Returns the orientation of the frame whose x axis is along `x` and whose y axis is in the plane
/// of `x` and `y`, like MuJoCo's xyaxes. The vectors must not be parallel or zero.
Eigen::Quaterniond FromXyAxes(const Eigen::Vector3d& x, const Eigen::Vector3d& y);
/// Returns the smallest rotation that maps +z to the direction of `z` (not zero), like MuJoCo's
/// zaxis.
Eigen::Quaterniond FromZAxis(const Eigen::Vector3d& z);

}  // namespace mjforge::model
