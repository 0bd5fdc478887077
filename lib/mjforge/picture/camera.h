// Camera that frames a set of shapes.

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
  double radius = 0;        // radius of this sphere, m

  /// Returns the position of a point of the world in a picture of this size, in pixels from the top
  /// left.
  Eigen::Vector2d Project(const Eigen::Vector3d& point, int width, int height) const;
};

/// The light that casts the shadow of the shapes, and the floor that receives it.
struct Shadow {
  Eigen::Vector3d light;  // direction of the light in the world frame, downwards
  double level = 0;       // z of the floor, m
};

/// Returns a camera for a picture with this ratio of width to height. All shapes are in the
/// picture, and so is their shadow if the camera looks down, unless `view` sets the distance.
Camera FrameShapes(const PlacedShapes& shapes, double width, double height, const View& view = {},
                   const std::optional<Shadow>& shadow = {});

/// Depth of a level plane in a picture, as OpenGL stores it: 0 at the camera's near plane, 1 at its
/// far plane. The depth is linear in the position in the picture, because the reciprocal of the
/// distance is, too.
struct LevelDepth {
  double at_corner = 1;  // in the upper left corner of the picture
  double per_x = 0;      // per pixel to the right
  double per_y = 0;      // per pixel downwards
};
/// Distance of the backdrop, a plane behind the shapes, as a share of the camera's far distance.
inline constexpr double kBackdrop = 0.98;
/// Returns a depth, as OpenGL stores it, between the shapes and the backdrop.
double DepthBeforeBackdrop(const Camera& camera);
/// Returns the depths of the plane z = `level` in a picture of this size in pixels. The depths
/// are above 1 where the plane is not in front of the camera.
LevelDepth DepthOfLevel(const Camera& camera, double level, int width, int height);

/// Returns MuJoCo's camera for rows [top, bottom) of a picture that is `height` rows high.
mjvGLCamera BandOf(const Camera& camera, int top, int bottom, int height);

}  // namespace mjforge::picture
