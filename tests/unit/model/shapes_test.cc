// Tests of support functions and bounding boxes.

#include "mjforge/model/shapes.h"

#include <catch2/catch.hpp>

namespace mjforge::model {
namespace {

TEST_CASE("every type has MuJoCo's word and number of sizes") {
  struct Row {
    GeomType type;
    std::string_view name;
    int count;
  };
  for (const Row& row :
       {Row{GeomType::kSphere, "sphere", 1}, Row{GeomType::kCapsule, "capsule", 2},
        Row{GeomType::kEllipsoid, "ellipsoid", 3}, Row{GeomType::kCylinder, "cylinder", 2},
        Row{GeomType::kBox, "box", 3}, Row{GeomType::kMesh, "mesh", 0}}) {
    CHECK(GeomTypeName(row.type) == row.name);
    CHECK(SizeCount(row.type) == row.count);
  }
}

TEST_CASE("support grows with the length of the direction") {
  const Shape box = {.type = GeomType::kBox, .size = {1, 2, 3}};
  CHECK(Support(box, {1, -1, 1}) == 6);
  CHECK(Support(box, {2, -2, 2}) == 12);
  const Shape capsule = {.type = GeomType::kCapsule, .size = {1, 2, 0}};
  CHECK(Support(capsule, {0, 0, -2}) == 6);
  const Shape cylinder = {.type = GeomType::kCylinder, .size = {1, 2, 0}};
  CHECK(Support(cylinder, {3, 4, 1}) == 7);
  const Shape ellipsoid = {.type = GeomType::kEllipsoid, .size = {1, 2, 3}};
  CHECK(Support(ellipsoid, {0, 1, 0}) == 2);
  const Shape sphere = {.type = GeomType::kSphere, .size = {2, 0, 0}};
  CHECK(Support(sphere, {3, 0, 4}) == 10);
}

TEST_CASE("bounds are exact for turned shapes") {
  const Pose tilted = {.p = {1, 0, 0}, .q = FromEuler({0, M_PI / 4, 0})};
  const double half = std::sqrt(0.5);
  const Box3 cylinder = BoundsOf({.type = GeomType::kCylinder, .size = {1, 2, 0}}, tilted);
  CHECK(cylinder.max.x() == Approx(1 + 3 * half).epsilon(1e-14));
  CHECK(cylinder.max.y() == Approx(1).epsilon(1e-14));
  CHECK(cylinder.min.z() == Approx(-3 * half).epsilon(1e-14));
  const Box3 ellipsoid = BoundsOf({.type = GeomType::kEllipsoid, .size = {1, 2, 3}}, tilted);
  CHECK(ellipsoid.max.x() == Approx(1 + std::sqrt(5)).epsilon(1e-14));
  CHECK(ellipsoid.min.z() == Approx(-std::sqrt(5)).epsilon(1e-14));
}

TEST_CASE("an empty box grows to what is added") {
  Box3 box;
  CHECK(box.empty());
  box.Add({.min = {0, 0, 0}, .max = {1, 1, 1}});
  box.Add({.min = {-1, 0.5, 0}, .max = {0, 3, 1}});
  CHECK(box.min == Eigen::Vector3d(-1, 0, 0));
  CHECK(box.max == Eigen::Vector3d(1, 3, 1));
}

}  // namespace
}  // namespace mjforge::model
