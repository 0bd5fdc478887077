#include "mjforge/picture/camera.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace mjforge::picture {
namespace {

PlacedShape Box(const Eigen::Vector3d& half_size, const Eigen::Vector3d& center) {
  PlacedShape shape;
  shape.solid.size = half_size;
  shape.p_WS = center;
  return shape;
}

// Bounds of a box in the picture: left, right, top, bottom.
Eigen::Vector4d Extremes(const Camera& camera, const PlacedShape& box, int width, int height) {
  Eigen::Vector4d extremes(1e9, -1e9, 1e9, -1e9);
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d p = box.solid.size;
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) != 0) p[axis] = -p[axis];
    }
    const Eigen::Vector2d at = camera.Project(box.p_WS + p, width, height);
    extremes = {std::min(extremes[0], at.x()), std::max(extremes[1], at.x()),
                std::min(extremes[2], at.y()), std::max(extremes[3], at.y())};
  }
  return extremes;
}

TEST_CASE("the depth of a level plane is that of its points, and above 1 beyond the horizon") {
  PlacedShapes shapes;
  shapes.Add(Box({0.1, 0.2, 0.4}, {1, 2, 3}));
  const Camera camera = FrameShapes(shapes, 300, 200);
  const LevelDepth level = DepthOfLevel(camera, 2.5, 300, 200);
  for (const Eigen::Vector3d& point :
       {Eigen::Vector3d(1, 2, 2.5), Eigen::Vector3d(1.3, 2, 2.5), Eigen::Vector3d(1, 1.6, 2.5)}) {
    const Eigen::Vector2d at = camera.Project(point, 300, 200);
    const double z = (point - camera.eye).dot(camera.forward);
    const double depth = camera.far / (camera.far - camera.near) * (1 - camera.near / z);
    CHECK(level.at_corner + level.per_x * at.x() + level.per_y * at.y() == Approx(depth));
  }
  const LevelDepth above = DepthOfLevel(camera, camera.eye.z() + 1, 300, 200);
  CHECK(above.at_corner > 1);
}

TEST_CASE("the backdrop is behind the shapes, with a depth between both") {
  PlacedShapes shapes;
  shapes.Add(Box({0.1, 0.2, 0.4}, {1, 2, 3}));
  const Camera camera = FrameShapes(shapes, 300, 200);
  const auto depth_at = [&](double z) {
    return camera.far / (camera.far - camera.near) * (1 - camera.near / z);
  };
  const double middle = (camera.center - camera.eye).dot(camera.forward);
  CHECK(DepthBeforeBackdrop(camera) > depth_at(middle + camera.radius) + 1e-3);
  CHECK(DepthBeforeBackdrop(camera) < depth_at(kBackdrop * camera.far) - 1e-5);
}

TEST_CASE("the shadow is in the picture, too") {
  const PlacedShape box = Box({0.1, 0.1, 0.4}, {0, 0, 0.4});
  PlacedShapes shapes;
  shapes.Add(box);
  const Eigen::Vector3d light(1, 0.5, -1);
  const auto most = [&](const Camera& camera) {
    double right = 0;
    for (const double y : {-0.1, 0.1}) {
      const Eigen::Vector3d corner = Eigen::Vector3d(0.1, y, 0.8) + 0.8 * light;  // on the floor
      right = std::max(right, camera.Project(corner, 200, 200).x());
    }
    return right;
  };
  CHECK(most(FrameShapes(shapes, 200, 200)) > 210);
  const Camera camera = FrameShapes(shapes, 200, 200, {}, Shadow{light, 0});
  CHECK(most(camera) == Approx(196));  // 0.04 of half the width
  CHECK(Extremes(camera, box, 200, 200)[0] > 9.99);
  View from_below;
  from_below.elevation = 20;
  CHECK(FrameShapes(shapes, 200, 200, from_below, Shadow{light, 0}).eye ==
        FrameShapes(shapes, 200, 200, from_below).eye);
}

TEST_CASE("a box fills the picture up to the margin, and is in the middle") {
  const PlacedShape box = Box({0.1, 0.2, 0.4}, {1, 2, 3});
  PlacedShapes shapes;
  shapes.Add(box);
  const Eigen::Vector4d place = Extremes(FrameShapes(shapes, 300, 200), box, 300, 200);
  CHECK(place[2] == Approx(10));  // a tenth of half the height
  CHECK(place[3] == Approx(190));
  CHECK(place[0] > 15);
  CHECK(place[0] + place[1] == Approx(300));
}

TEST_CASE("a wide box fills the picture from side to side") {
  const PlacedShape box = Box({3, 0.1, 0.1}, {0, 0, 0});
  PlacedShapes shapes;
  shapes.Add(box);
  const Eigen::Vector4d place = Extremes(FrameShapes(shapes, 200, 200), box, 200, 200);
  CHECK(place[0] == Approx(10));
  CHECK(place[1] == Approx(190));
  CHECK(place[2] + place[3] == Approx(200));
}

TEST_CASE("a zoom divides the distance from the middle of the shapes") {
  PlacedShapes shapes;
  shapes.Add(Box({0.1, 0.2, 0.4}, {1, 2, 3}));
  const Camera fitted = FrameShapes(shapes, 300, 200);
  const double distance = (fitted.center - fitted.eye).dot(fitted.forward);
  View view;
  view.zoom = 2;
  const Camera near = FrameShapes(shapes, 300, 200, view);
  CHECK((near.center - near.eye).norm() == Approx(distance / 2));
  CHECK(near.forward == fitted.forward);
  view.distance = 3;
  CHECK((FrameShapes(shapes, 300, 200, view).eye - near.center).norm() == Approx(3));
}

TEST_CASE("planes near and far hold the object at every size") {
  for (const double scale : {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    CAPTURE(scale);
    PlacedShapes shapes;
    shapes.Add(Box(scale * Eigen::Vector3d(1, 2, 0.5), {0, 0, 0}));
    const Camera camera = FrameShapes(shapes, 100, 100);
    CHECK(camera.near > 0);
    CHECK(camera.near < -shapes.Support(-camera.forward) - camera.forward.dot(camera.eye));
    CHECK(camera.far > shapes.Support(camera.forward) - camera.forward.dot(camera.eye));
    CHECK(camera.far / camera.near < 100);
    CHECK(camera.radius == Approx(scale * std::sqrt(5.25)));
  }
}

TEST_CASE("a rod that points at the camera is in front of it") {
  PlacedShapes shapes;
  const Camera probe = [] {
    PlacedShapes any;
    any.Add(Box({1, 1, 1}, {0, 0, 0}));
    return FrameShapes(any, 1, 1);
  }();
  for (const double along : {-1.0, 1.0}) shapes.Add(Box({0.01, 0.01, 0.01}, along * probe.forward));
  const Camera camera = FrameShapes(shapes, 100, 100);
  CHECK(camera.near > 0);
}

TEST_CASE("bands of a picture share their edges") {
  PlacedShapes shapes;
  shapes.Add(Box({1, 1, 1}, {0, 0, 0}));
  const Camera camera = FrameShapes(shapes, 100, 100);
  const mjvGLCamera upper = BandOf(camera, 0, 30, 100);
  const mjvGLCamera lower = BandOf(camera, 30, 100, 100);
  CHECK(upper.frustum_bottom == lower.frustum_top);
  CHECK(upper.frustum_top == -lower.frustum_bottom);
  CHECK(upper.frustum_top == Approx(camera.near * camera.tan_y));
}

}  // namespace
}  // namespace mjforge::picture
