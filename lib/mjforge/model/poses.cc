// Composition of poses, and conversion of MJCF's orientations to quaternions.

#include "mjforge/model/poses.h"

#include <cmath>

namespace mjforge::model {

Pose Pose::operator*(const Pose& X_BC) const { return {q * X_BC.p + p, (q * X_BC.q).normalized()}; }

Eigen::Quaterniond FromEuler(const Eigen::Vector3d& angles) {
  const Eigen::Quaterniond x(Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()));
  const Eigen::Quaterniond y(Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()));
  const Eigen::Quaterniond z(Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()));
  return (x * y * z).normalized();
}

Eigen::Quaterniond FromAxisAngle(const Eigen::Vector3d& axis, double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.stableNormalized()));
}

Eigen::Quaterniond FromXyAxes(const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
  Eigen::Matrix3d axes;
  axes.col(0) = x.stableNormalized();
  axes.col(1) = (y - axes.col(0) * axes.col(0).dot(y)).stableNormalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return Eigen::Quaterniond(axes).normalized();
}

// If z points exactly down, the rotation is a half turn about x, as in mjuu_z2quat of MuJoCo 2.2
// (src/user/user_util.cc).
Eigen::Quaterniond FromZAxis(const Eigen::Vector3d& z) {
  const Eigen::Vector3d unit = z.stableNormalized();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ().cross(unit);
  const double sine = axis.norm();
  axis = sine < 1e-10 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d(axis / sine);
  return Eigen::Quaterniond(Eigen::AngleAxisd(std::atan2(sine, unit.z()), axis)).normalized();
}

}  // namespace mjforge::model
