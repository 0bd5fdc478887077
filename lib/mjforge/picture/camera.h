#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Dense>

#include "mjforge/picture/picture.h"
#include "mjforge/picture/support.h"

namespace mjforge::picture {

/// A camera that looks at some shapes.
struct Camera {
  Eigen::Vector3d eye;      // W
  Eigen::Vector3d right;    // W, unit
  Eigen::Vector3d up;       // W, unit
  Eigen::Vector3d forward;  // W, unit
  double tan_x = 0;         // of half the angle of view, from side to side
  double tan_y = 0;         // from top to bottom
  double near = 0;          // m
  double far = 0;           // m
  Eigen::Vector3d center;   // of a ball around the shapes
  double radius = 0;        // of that ball, m

  /// Where a point of the world is in a picture of this size, from its top left, pixels.
  Eigen::Vector2d Project(const Eigen::Vector3d& point, int width, int height) const;
};

/// A camera for a picture of this shape.
Camera FrameShapes(const Shapes& shapes, double width, double height, const View& view = {});

/// The camera for rows [top, bottom) of a picture `height` rows high.
mjvGLCamera BandOf(const Camera& camera, int top, int bottom, int height);

}  // namespace mjforge::picture
