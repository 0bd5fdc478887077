#include "mjforge/picture/support.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace mjforge::picture {
namespace {

using Eigen::Vector3d;

/// Size in the order of mjvGeom: the half length is the third number.
PlacedShape Make(int type, const Eigen::Vector3f& size) {
  mjvGeom geom = {};
  geom.type = type;
  std::ranges::copy(size, geom.size);
  PlacedShape shape = ShapeOf({}, geom);
  shape.p_WS = {1, 0, 0};
  shape.R_WS = Eigen::AngleAxisd(std::acos(0.0), Vector3d::UnitY()).toRotationMatrix();  // z to x
  return shape;
}

TEST_CASE("shapes reach as far as their formulas say") {
  const Vector3d x = Vector3d::UnitX();
  const Vector3d z = Vector3d::UnitZ();
  CHECK(Make(mjGEOM_SPHERE, {2, 2, 2}).Support(x) == Approx(3));
  CHECK(Make(mjGEOM_ELLIPSOID, {1, 2, 3}).Support(x) == Approx(4));
  CHECK(Make(mjGEOM_CAPSULE, {1, 1, 3}).Support(x) == Approx(5));
  CHECK(Make(mjGEOM_CAPSULE, {1, 1, 3}).Support(z) == Approx(1));
  CHECK(Make(mjGEOM_CYLINDER, {1, 1, 3}).Support(x) == Approx(4));
  CHECK(Make(mjGEOM_CYLINDER, {1, 1, 3}).Support((x + z).normalized()) ==
        Approx((1 + 4) / std::sqrt(2.0)));
  CHECK(Make(mjGEOM_BOX, {1, 2, 3}).Support(-x) == Approx(2));
}

TEST_CASE("of a mesh its vertices count") {
  const float vertices[] = {0, 0, 0, 1, 2, 3};
  PlacedShape shape = Make(mjGEOM_MESH, {9, 9, 9});
  shape.vertices = vertices;
  CHECK(shape.Support(Vector3d::UnitX()) == Approx(4));
  CHECK(shape.Support(-Vector3d::UnitX()) == Approx(-1));
}

TEST_CASE("the horizontal radius is that of the farthest corner") {
  PlacedShape box;
  box.solid.size = {3, 4, 1};
  PlacedShapes shapes;
  shapes.Add(box);
  CHECK(shapes.HorizontalRadius(Vector3d::Zero()) == Approx(5).epsilon(1e-5));
  CHECK(shapes.HorizontalRadius({3, 4, 7}) == Approx(10).epsilon(1e-5));
}

}  // namespace
}  // namespace mjforge::picture
