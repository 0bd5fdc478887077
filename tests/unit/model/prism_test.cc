#include <vector>

#include <catch2/catch.hpp>

#include "mjforge/model/meshes.h"
#include "mjforge/model/shapes.h"

namespace mjforge::model {
namespace {

std::string WhyNot(const std::vector<double>& polygon) {
  std::string why_not;
  CHECK_FALSE(MakePrism(polygon, 1, why_not));
  return why_not;
}

TriangleMesh Prism(const std::vector<double>& polygon, double height) {
  std::string why_not;
  std::optional<TriangleMesh> mesh = MakePrism(polygon, height, why_not);
  INFO(why_not);
  REQUIRE(mesh);
  return *mesh;
}

TEST_CASE("a prism is centred on z = 0 and faces outwards whichever way its corners go") {
  for (const std::vector<double>& polygon :
       {std::vector<double>{0, 0, 2, 0, 2, 1, 0, 1}, {0, 1, 2, 1, 2, 0, 0, 0}}) {
    const TriangleMesh mesh = Prism(polygon, 3);
    CHECK(mesh.vertices.size() == 8);
    CHECK(mesh.triangles.size() == 12);
    CHECK(WhyNotSolid(mesh) == std::nullopt);
    const Shape shape = {.type = GeomType::kMesh, .mesh = &mesh};
    CHECK(Volume(shape) == Approx(6).epsilon(1e-14));
    const Box3 box = BoundsOf(shape, Pose());
    CHECK(box.min == Eigen::Vector3d(0, 0, -1.5));
    CHECK(box.max == Eigen::Vector3d(2, 1, 1.5));
  }
}

TEST_CASE("repeated corners and corners on a straight side are left out") {
  CHECK(Prism({0, 0, 0, 0, 1, 0, 2, 0, 2, 1, 0, 1, 0, 0}, 1).vertices.size() == 8);
}

TEST_CASE("a polygon with fewer than three different corners is refused") {
  CHECK(WhyNot({}) == "polygon needs at least 3 corners");
  CHECK(WhyNot({0, 0, 1, 1}) == "polygon needs at least 3 corners");
  CHECK(WhyNot({0, 0, 1, 1, 1, 1, 0, 0}) == "polygon needs at least 3 corners");
}

TEST_CASE("a polygon on a line is refused") {
  CHECK(WhyNot({0, 0, 1, 1, 2, 2}) == "polygon has no area");
}

TEST_CASE("a dent is named by its corner") {
  CHECK(WhyNot({0, 0, 4, 0, 1, 1, 0, 4}) == "polygon is not convex at corner 3");
  CHECK(WhyNot({0, 4, 1, 1, 4, 0, 0, 0}) == "polygon is not convex at corner 2");
}

TEST_CASE("a spike is not convex") {
  CHECK(WhyNot({0, 0, 4, 0, 4, 4, 8, 4, 4, 4, 0, 4}) == "polygon is not convex at corner 3");
}

TEST_CASE("a star that turns one way all the time is not convex") {
  // The pentagram 0, 2, 4, 1, 3 of a regular pentagon.
  std::vector<double> star;
  for (const int i : {0, 2, 4, 1, 3}) {
    star.push_back(std::cos(2 * M_PI * i / 5));
    star.push_back(std::sin(2 * M_PI * i / 5));
  }
  CHECK(WhyNot(star) == "polygon is not convex at corner 3");
}

TEST_CASE("numbers that are not finite make no prism") {
  CHECK(WhyNot({0, 0, 1, 0, std::nan(""), 1}) == "polygon has no area");
}

}  // namespace
}  // namespace mjforge::model
