// Perspective camera that frames a set of shapes, and depths of planes in its picture.

#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <optional>

#include "mjforge/picture/picture.h"
#include "mjforge/picture/support.h"

namespace mjforge::picture {

/// A perspective camera that looks at some shapes. W is the world frame.
struct Camera {
  Eigen::Vector3d eye;      // W, m
  Eigen::Vector3d right;    // W, unit
  Eigen::Vector3d up;       // W, unit
  Eigen::Vector3d forward;  // W, unit
  double tan_x = 0;         // tangent of half the horizontal field of view
  double tan_y = 0;         // tangent of half the vertical field of view
  double near = 0;          // m, distance of the near plane from the eye
  double far = 0;           // m, distance of the far plane from the eye
  Eigen::Vector3d center;   // W, m, center of a sphere around the shapes
  double radius = 0;        // m, radius of this sphere

  /// Returns the position, in pixels from the top left, of a point in the world frame in a picture
  /// of this size. The point must be in front of the camera.
  Eigen::Vector2d Project(const Eigen::Vector3d& point, int width, int height) const;
};

/// The light that casts the shadow of the shapes, and the floor that receives it.
struct Shadow {
  Eigen::Vector3d light;  // direction of the light in the world frame, downwards
  double level = 0;       // z of the floor, m
};

/// Returns a camera for a picture with this ratio of width to height. The distance is the smallest
/// at which all shapes and, if the camera looks down, their shadow are in the picture, unless
/// `view` changes the distance.
Camera FrameShapes(const PlacedShapes& shapes, double width, double height, const View& view = {},
                   const std::optional<Shadow>& shadow = {});

/// Depth of a level plane in a picture, as OpenGL stores it: 0 at the camera's near plane, 1 at its
/// far plane. This depth is linear in the position in the picture, because the reciprocal of the
/// plane's distance from the camera is linear.
struct LevelDepth {
  double at_corner = 1;  // in the upper left corner of the picture
  double per_x = 0;      // per pixel to the right
  double per_y = 0;      // per pixel downwards
};
/// Distance of the backdrop (a plane behind the shapes) from the eye, as a share of Camera::far.
inline constexpr double kBackdrop = 0.98;
/// Returns a threshold for depths as OpenGL stores them: those of the shapes are smaller, that of
/// the backdrop is larger.
double DepthBeforeBackdrop(const Camera& camera);

/// Returns the depths of the plane z = `level` in a picture of this size in pixels. The depths are
/// above 1 where the camera does not see the plane.
LevelDepth DepthOfLevel(const Camera& camera, double level, int width, int height);

/// Returns MuJoCo's camera that renders only the rows [top, bottom), counted from the top, of a
/// picture that is `height` rows high.
mjvGLCamera BandOf(const Camera& camera, int top, int bottom, int height);

}  // namespace mjforge::picture
