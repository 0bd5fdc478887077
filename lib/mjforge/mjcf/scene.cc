// Writers of the floor, light and camera that the target `scene` adds, and the height by which the
// object is raised onto the floor.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjforge/mjcf/section_writers.h"

namespace mjforge::mjcf {
namespace {

// The names of floor, light and camera contain a hyphen ("scene-floor"). Therefore they never clash
// with names of the object, which cannot contain a hyphen.

bool IsFinite(const model::Box3& box) { return box.min.allFinite() && box.max.allFinite(); }

// Returns the orientation of an upright camera at `eye` that looks along its -z axis at `target`.
Eigen::Quaterniond LookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  Eigen::Matrix3d axes;
  axes.col(2) = (eye - target).normalized();
  axes.col(0) = Eigen::Vector3d::UnitZ().cross(axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return Eigen::Quaterniond(axes);
}

// Positions of light and camera for a box on the floor, m.
struct SceneView {
  Eigen::Vector3d center;
  Eigen::Vector3d light;
  Eigen::Vector3d eye;
};

SceneView ViewOf(const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  Eigen::Vector3d center = (min + max) / 2;
  center.z() -= min.z();
  const double radius = std::max((max - min).norm() / 2, 1e-3);  // m
  // The default vertical field of view of MuJoCo's cameras is 45 degrees.
  constexpr double kHalfView = 22.5 * std::numbers::pi / 180;
  return {center, center + radius * Eigen::Vector3d(1, -2, 6),
          center + 1.1 * radius / std::sin(kHalfView) * Eigen::Vector3d(1, -1.5, 1).normalized()};
}

// Returns the z coordinate of the lowest point of all colliding geoms at the start, m. Geoms that
// approximate an exact solid may be lower than the solid. Returns infinity if no geom collides.
double LowestOfGeoms(const model::Object& object) {
  model::Box3 box;
  const std::vector<model::Pose> X_WB = model::BodyPoses(object);
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    for (const model::Part& part : object.bodies[i].parts) {
      if (part.role == model::Role::kVisual) continue;
      box.Add(model::BoundsOf(part.shape, X_WB[i] * part.X_BG));
    }
  }
  return box.min.z();
}

}  // namespace

double LiftOntoFloor(const model::Object& object) {
  if (object.bodies.empty()) return 0;
  double lowest = object.bounds.aabb.min.z();
  if (!object.bounds.declared) lowest = std::min(lowest, LowestOfGeoms(object));
  return std::isfinite(lowest) ? -lowest : 0;
}

void WriteSceneAssets(ElementWriter& writer) {
  writer.WriteLine(
      "<texture name=\"scene-floor\" type=\"2d\" builtin=\"checker\" rgb1=\"0.8 0.8 0.8\" "
      "rgb2=\"0.65 0.65 0.65\" width=\"300\" height=\"300\"/>");
  writer.WriteLine(
      "<material name=\"scene-floor\" texture=\"scene-floor\" texuniform=\"true\" "
      "texrepeat=\"10 10\"/>");
}

void WriteSceneWorld(const model::Object& object, ElementWriter& writer) {
  model::Box3 box = object.bounds.aabb;
  if (!IsFinite(box)) box = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  const SceneView view = ViewOf(box.min, box.max);

  writer.OpenElement("light");
  writer.WriteText("name", "scene-light");
  writer.WritePoint("pos", view.light);
  writer.WritePoint("dir", Eigen::Vector3d(-1, 2, -6).normalized());
  writer.CloseEmpty();
  writer.OpenElement("camera");
  writer.WriteText("name", "scene-camera");
  writer.WritePose({view.eye, LookAt(view.eye, view.center)});
  writer.CloseEmpty();

  writer.WriteLine(
      "<geom name=\"scene-floor\" type=\"plane\" size=\"0 0 1\" pos=\"0 0 0\" "
      "material=\"scene-floor\"/>");
}

}  // namespace mjforge::mjcf
