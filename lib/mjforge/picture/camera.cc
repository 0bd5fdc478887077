// Camera placement: fits convex shapes into the viewing frustum by their support functions.

#include "mjforge/picture/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace mjforge::picture {
namespace {

// Default direction from the object to the eye: from the front, right and above.
const Eigen::Vector3d kToEye(1, -1.55, 1.05);
// Half the field of view along the picture's shorter side, rad. A small angle (a long lens) keeps
// vertical edges nearly parallel.
constexpr double kHalfAngle = 12.5 * std::numbers::pi / 180;
// Margin between the shapes and each side of the picture, as a share of half the picture.
constexpr double kMargin = 0.10;
// Margin between the shadow and each side, as a share of half the picture; smaller, because shadows
// matter less.
constexpr double kShadowMargin = 0.04;

// Minimum radius of the shapes' bounding sphere, so that a single point can be framed.
constexpr double kSmallest = 1e-9;  // m

// Returns the coordinate of the eye along `across`, an axis of the picture, from which the two
// opposite edges of the silhouette appear at the same angle to `forward`. `depth` is the coordinate
// of the eye along `forward`. Bisection finds the tangent of the angle, which is at most `most`.
double CenterEye(const PlacedShapes& shapes, const Eigen::Vector3d& across,
                 const Eigen::Vector3d& forward, double depth, double most) {
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

// Values of a support function for the outward normals of two opposite sides of a frustum.
// `tangent` is the tangent of half the angle between the sides.
struct Sides {
  double tangent = 0;
  double right = 0;
  double left = 0;
};

// Positions of the eye along one axis of the picture from which the shapes and the shadow are
// visible between both sides of the frustum.
class EyeRange {
 public:
  EyeRange(const PlacedShapes& shapes, const std::optional<Shadow>& shadow,
           const Eigen::Vector3d& across, const Eigen::Vector3d& forward, double tangent) {
    const auto add = [&](double share, const auto& support) {
      const double t = tangent * (1 - share);
      sides_.push_back({t, support(across - t * forward), support(-across - t * forward)});
    };
    add(kMargin, [&](const Eigen::Vector3d& side) { return shapes.Support(side); });
    if (!shadow) return;
    add(kShadowMargin, [&](const Eigen::Vector3d& side) {
      return shapes.ShadowSupport(side, shadow->light, shadow->level);
    });
  }

  // Returns the largest coordinate of the eye along the viewing direction for which there is a
  // position along the axis that shows all shapes and the shadow.
  double LargestDepth() const {
    double largest = std::numeric_limits<double>::infinity();
    for (const Sides& a : sides_) {
      for (const Sides& b : sides_)
        largest = std::min(largest, -(a.right + b.left) / (a.tangent + b.tangent));
    }
    return largest;
  }

  // Returns the position along the axis that is nearest to `wanted` and shows all shapes and the
  // shadow, for an eye whose coordinate along the viewing direction is `depth`.
  double Nearest(double wanted, double depth) const {
    for (const Sides& side : sides_) wanted = std::max(wanted, side.right + side.tangent * depth);
    for (const Sides& side : sides_) wanted = std::min(wanted, -side.left - side.tangent * depth);
    return wanted;
  }

 private:
  std::vector<Sides> sides_;
};

// Sets the camera's axes. Computes `right` from the azimuth if the view has angles, because the
// cross product with z would be zero for a camera that looks straight down.
void SetAxes(const View& view, Camera& camera) {
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

// Shapes are inside a frustum if and only if, for each of the frustum's four sides, their support
// point in the direction of the side's outward normal is inside. Each pair of opposite sides gives
// an upper bound of `depth`, the coordinate of the eye along the viewing direction.
Camera FrameShapes(const PlacedShapes& shapes, double width, double height, const View& view,
                   const std::optional<Shadow>& shadow) {
  Camera camera;
  SetAxes(view, camera);
  const double shorter = std::min(width, height);
  camera.tan_x = std::tan(kHalfAngle) * width / shorter;
  camera.tan_y = std::tan(kHalfAngle) * height / shorter;

  const Eigen::Vector3d min = shapes.Min();
  const Eigen::Vector3d max = shapes.Max();
  camera.center = (min + max) / 2;
  camera.radius = std::max((max - min).norm() / 2, kSmallest);

  const std::optional<Shadow> seen = camera.forward.z() < 0 ? shadow : std::nullopt;
  const EyeRange x(shapes, seen, camera.right, camera.forward, camera.tan_x);
  const EyeRange y(shapes, seen, camera.up, camera.forward, camera.tan_y);
  const double nearest = -shapes.Support(-camera.forward);
  const double depth =
      std::min({x.LargestDepth(), y.LargestDepth(), nearest - 0.5 * camera.radius});
  const auto center = [&](const Eigen::Vector3d& across, double tangent) {
    return CenterEye(shapes, across, camera.forward, depth, tangent * (1 - kMargin));
  };
  camera.eye = x.Nearest(center(camera.right, camera.tan_x), depth) * camera.right +
               y.Nearest(center(camera.up, camera.tan_y), depth) * camera.up +
               depth * camera.forward;
  camera.near = 0.5 * (nearest - depth);
  if (view.distance || view.zoom != 1) {
    const double fitted = (camera.center - camera.eye).dot(camera.forward);
    const double distance = view.distance.value_or(fitted / view.zoom);
    camera.eye = camera.center - distance * camera.forward;
    // Keeps the near plane in front of the eye even if the eye is inside the shapes.
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

// A viewing ray whose direction has the component 1 along `forward` and dz along z meets the plane
// at the distance (level - z) / dz along `forward`, where z is the height of the eye. Because dz is
// linear in the position in the picture, the inverse of this distance is linear, too.
LevelDepth DepthOfLevel(const Camera& camera, double level, int width, int height) {
  const double scale = camera.far / (camera.far - camera.near);
  const double to_depth = -scale * camera.near / (level - camera.eye.z());
  const double across = 2 * camera.tan_x / width * camera.right.z();
  const double down = -2 * camera.tan_y / height * camera.up.z();
  const double corner =
      camera.forward.z() - camera.tan_x * camera.right.z() + camera.tan_y * camera.up.z();
  return {scale + to_depth * corner, to_depth * across, to_depth * down};
}

double DepthBeforeBackdrop(const Camera& camera) {
  constexpr double kBefore = 0.99;
  const double depth = kBefore * kBackdrop * camera.far;
  return camera.far / (camera.far - camera.near) * (1 - camera.near / depth);
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
