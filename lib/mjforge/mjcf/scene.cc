#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjforge/mjcf/sections.h"

namespace mjforge::mjcf {
namespace {

// Names of the scene's own elements have a hyphen, which an object's cannot have.

bool Finite(const model::Box3& box) { return box.min.allFinite() && box.max.allFinite(); }

/// Looking from `eye` at `target`, upright: a camera looks along its -z, its y is up.
Eigen::Quaterniond LookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  Eigen::Matrix3d axes;
  axes.col(2) = (eye - target).normalized();
  axes.col(0) = Eigen::Vector3d::UnitZ().cross(axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return Eigen::Quaterniond(axes);
}

// Of a box on the floor.
struct View {
  Eigen::Vector3d center;
  Eigen::Vector3d light;
  Eigen::Vector3d eye;
};

View ViewOf(const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  Eigen::Vector3d center = (min + max) / 2;
  center.z() -= min.z();
  const double radius = std::max((max - min).norm() / 2, 1e-3);  // m
  // MuJoCo's cameras see 45 degrees from top to bottom.
  constexpr double kHalfView = 22.5 * std::numbers::pi / 180;
  return {center, center + radius * Eigen::Vector3d(1, -2, 6),
          center + 1.1 * radius / std::sin(kHalfView) * Eigen::Vector3d(1, -1.5, 1).normalized()};
}

}  // namespace

double LiftOntoFloor(const model::Object& object) {
  if (object.bodies.empty()) return 0;
  const double lowest = object.bounds.aabb.min.z();
  return std::isfinite(lowest) ? -lowest - object.bodies.front().X_PB.p.z() : 0;
}

void WriteSceneAssets(ElementWriter& writer) {
  writer.Line(
      "<texture name=\"scene-floor\" type=\"2d\" builtin=\"checker\" rgb1=\"0.8 0.8 0.8\" "
      "rgb2=\"0.65 0.65 0.65\" width=\"300\" height=\"300\"/>");
  writer.Line(
      "<material name=\"scene-floor\" texture=\"scene-floor\" texuniform=\"true\" "
      "texrepeat=\"10 10\"/>");
}

void WriteSceneWorld(const model::Object& object, ElementWriter& writer) {
  model::Box3 box = object.bounds.aabb;
  if (!Finite(box)) box = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  const View view = ViewOf(box.min, box.max);

  writer.Open("light");
  writer.Text("name", "scene-light");
  writer.Point("pos", view.light);
  writer.Point("dir", Eigen::Vector3d(-1, 2, -6).normalized());
  writer.Close();
  writer.Open("camera");
  writer.Text("name", "scene-camera");
  writer.Pose({view.eye, LookAt(view.eye, view.center)});
  writer.Close();

  writer.Line(
      "<geom name=\"scene-floor\" type=\"plane\" size=\"0 0 1\" pos=\"0 0 0\" "
      "material=\"scene-floor\"/>");
}

}  // namespace mjforge::mjcf
