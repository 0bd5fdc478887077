#include "mjforge/picture/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mjforge::picture {
namespace {

// From the object to the eye: front, a little from the right, from above.
const Eigen::Vector3d kToEye(1, -1.55, 1.05);
// A long lens, so that upright edges look upright.
constexpr double kHalfAngle = 12.5 * std::numbers::pi / 180;  // of the picture's shorter side
// What is left free at each side, of half the picture.
constexpr double kMargin = 0.10;

// Half the space's diagonal at least: nothing has less than its own size.
constexpr double kSmallest = 1e-9;  // m

Eigen::Vector3f ToFloat(const Eigen::Vector3d& v) { return v.cast<float>(); }

}  // namespace

// Shapes are inside a frustum exactly if their support in the direction of each
// of its four sides is: two sides give the eye's place across and its depth.
Camera FrameShapes(const Shapes& shapes, double width, double height) {
  Camera camera;
  camera.forward = -kToEye.normalized();
  camera.right = camera.forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  camera.up = camera.right.cross(camera.forward);
  const double shorter = std::min(width, height);
  camera.tan_x = std::tan(kHalfAngle) * width / shorter;
  camera.tan_y = std::tan(kHalfAngle) * height / shorter;

  const Eigen::Vector3d min = shapes.Min();
  const Eigen::Vector3d max = shapes.Max();
  camera.center = (min + max) / 2;
  camera.radius = std::max((max - min).norm() / 2, kSmallest);

  const double tx = camera.tan_x * (1 - kMargin);
  const double ty = camera.tan_y * (1 - kMargin);
  const double x_right = shapes.Support(camera.right - tx * camera.forward);
  const double x_left = shapes.Support(-camera.right - tx * camera.forward);
  const double y_up = shapes.Support(camera.up - ty * camera.forward);
  const double y_down = shapes.Support(-camera.up - ty * camera.forward);
  const double nearest = -shapes.Support(-camera.forward);
  const double depth = std::min(
      {-(x_right + x_left) / (2 * tx), -(y_up + y_down) / (2 * ty), nearest - 0.5 * camera.radius});
  camera.eye = (x_right - x_left) / 2 * camera.right + (y_up - y_down) / 2 * camera.up +
               depth * camera.forward;
  camera.near = 0.5 * (nearest - depth);
  camera.far = (camera.center - camera.eye).dot(camera.forward) + 12 * camera.radius;
  return camera;
}

Eigen::Vector2d Camera::Project(const Eigen::Vector3d& point, int width, int height) const {
  const Eigen::Vector3d p = point - eye;
  const double depth = p.dot(forward);
  return {(1 + p.dot(right) / (depth * tan_x)) * width / 2,
          (1 - p.dot(up) / (depth * tan_y)) * height / 2};
}

mjvGLCamera BandOf(const Camera& camera, int top, int bottom, int height) {
  mjvGLCamera band = {};
  Eigen::Map<Eigen::Vector3f>(band.pos) = ToFloat(camera.eye);
  Eigen::Map<Eigen::Vector3f>(band.forward) = ToFloat(camera.forward);
  Eigen::Map<Eigen::Vector3f>(band.up) = ToFloat(camera.up);
  const double half = camera.near * camera.tan_y;
  band.frustum_top = static_cast<float>(half * (1 - 2.0 * top / height));
  band.frustum_bottom = static_cast<float>(half * (1 - 2.0 * bottom / height));
  band.frustum_near = static_cast<float>(camera.near);
  band.frustum_far = static_cast<float>(camera.far);
  return band;
}

}  // namespace mjforge::picture
