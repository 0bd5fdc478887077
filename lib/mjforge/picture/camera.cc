#include "mjforge/picture/camera.h"

#include <algorithm>
#include <cmath>
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

// Where across the eye stands at a depth so that what sticks out to both sides is
// seen under the same angle: that angle's tangent is the least that holds all of it.
double Balanced(const Shapes& shapes, const Eigen::Vector3d& across, const Eigen::Vector3d& forward,
                double depth, double most) {
  constexpr int kSteps = 40;
  double least = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double tangent = (least + most) / 2;
    const double right = shapes.Support(across - tangent * forward);
    const double left = shapes.Support(-across - tangent * forward);
    (right + left + 2 * tangent * depth > 0 ? least : most) = tangent;
  }
  return (shapes.Support(across - most * forward) - shapes.Support(-across - most * forward)) / 2;
}

// Where it looks, and what is right of that: where it looks straight down, as the azimuth says.
void Turn(const View& view, Camera& camera) {
  constexpr double kDegree = std::numbers::pi / 180;
  camera.forward = -kToEye.normalized();
  camera.right = camera.forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  if (view.azimuth || view.elevation) {
    const double azimuth =
        view.azimuth ? *view.azimuth * kDegree : std::atan2(camera.forward.y(), camera.forward.x());
    const double elevation =
        view.elevation ? *view.elevation * kDegree : std::asin(camera.forward.z());
    camera.right = {std::sin(azimuth), -std::cos(azimuth), 0};
    camera.forward = {std::cos(elevation) * std::cos(azimuth),
                      std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
  }
  camera.up = camera.right.cross(camera.forward);
}

}  // namespace

// Shapes are inside a frustum exactly if their support in the direction of each
// of its four sides is; two opposite sides give the depth that the eye needs.
Camera FrameShapes(const Shapes& shapes, double width, double height, const View& view) {
  Camera camera;
  Turn(view, camera);
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
  camera.eye = Balanced(shapes, camera.right, camera.forward, depth, tx) * camera.right +
               Balanced(shapes, camera.up, camera.forward, depth, ty) * camera.up +
               depth * camera.forward;
  camera.near = 0.5 * (nearest - depth);
  if (view.distance) {
    camera.eye = camera.center - *view.distance * camera.forward;
    // Within the shapes, too, something must be between the two planes.
    camera.near = std::max(0.5 * (nearest - camera.eye.dot(camera.forward)), 0.01 * camera.radius);
  }
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
  Eigen::Map<Eigen::Vector3f>(band.pos) = camera.eye.cast<float>();
  Eigen::Map<Eigen::Vector3f>(band.forward) = camera.forward.cast<float>();
  Eigen::Map<Eigen::Vector3f>(band.up) = camera.up.cast<float>();
  const double half = camera.near * camera.tan_y;
  band.frustum_top = static_cast<float>(half * (1 - 2.0 * top / height));
  band.frustum_bottom = static_cast<float>(half * (1 - 2.0 * bottom / height));
  band.frustum_near = static_cast<float>(camera.near);
  band.frustum_far = static_cast<float>(camera.far);
  return band;
}

}  // namespace mjforge::picture
