// Random tries of places, checked by other means.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "harness/effort.h"
#include "mjforge/placing/obstacles.h"
#include "table.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::GeomType;
using model::PlaceResult;
using model::PlaceTry;
using model::PlaceVerdict;
using model::Shape;

// Points of a shape: farthest points in random directions, and points between two of them.
std::vector<Vector3d> PointsOf(const distance::PlacedShape& placed, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<Vector3d> points;
  for (int i = 0; i < 150; ++i) {
    points.push_back(
        FarthestPoint(placed, Vector3d(normal(random), normal(random), normal(random))));
    points.push_back((points.back() + points[random() % points.size()]) / 2);
  }
  return points;
}

// Returns the largest gap of two parallel planes between shapes, in some random directions.
double LargestGap(const distance::PlacedShape& a, const distance::PlacedShape& b,
                  std::mt19937& random) {
  std::normal_distribution<double> normal;
  double gap = -1;
  for (int i = 0; i < 500; ++i) {
    const Vector3d n = Vector3d(normal(random), normal(random), normal(random)).normalized();
    gap = std::max(gap, n.dot(FarthestPoint(b, -n)) - n.dot(FarthestPoint(a, n)));
  }
  return gap;
}

Shape AnyShape(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0.01, 0.06);
  const std::array types = {GeomType::kSphere, GeomType::kCapsule, GeomType::kEllipsoid,
                            GeomType::kCylinder, GeomType::kBox};
  return ShapeOf(types[random() % 5], uniform(random), uniform(random), uniform(random));
}

PlaceTry AnyTry(const Table& table, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  PlaceTry where = table.Where(uniform(random), uniform(random));
  if (table.region.type == model::RegionType::kDisc) where.uv *= std::sqrt(0.5);
  where.yaw = 4 * uniform(random);
  if (random() % 3 == 0) where.facing = Vector2d(uniform(random), uniform(random));
  if (random() % 2 == 0) where.lying = model::FromAxisAngle(Vector3d::UnitX(), M_PI / 2);
  where.clear = random() % 2 == 0 ? 0 : 0.02;
  return where;
}

// Checks that a body that stands is inside the region, on it, and away from all others.
void CheckStands(const Table& table, int body, double clear, std::mt19937& random) {
  const std::vector<BodyShape> shapes = ShapesBelow(table.scene.object, body);
  const distance::PlacedShape own = ShapesAt(shapes, PoseInWorld(table.scene.object, body))[0];
  const double bottom = own.box_W.min().z();
  const bool is_box = own.shape.type == model::GeomType::kBox;
  CHECK(std::abs(bottom - (is_box ? kContactGap : -kContactDepth)) < 1e-7);
  const std::vector<Vector3d> points = PointsOf(own, random);
  for (const Vector3d& p : points) {
    if (p.z() > bottom + 1e-3) continue;
    CHECK((table.region.type == model::RegionType::kDisc
               ? p.head<2>().norm() <= table.region.half_size.x() + 1e-4
               : ((p.head<2>().cwiseAbs() - table.region.half_size).array() <= 1e-4).all()));
  }
  for (int other = 1; other < body; ++other) {
    const std::vector<BodyShape> of = ShapesBelow(table.scene.object, other);
    const auto standing = ShapesAt(of, PoseInWorld(table.scene.object, other));
    if (standing[0].X_WG.p.z() == 0) continue;  // found no place
    const std::vector<Vector3d> others = PointsOf(standing[0], random);
    double nearest = 1;
    for (const Vector3d& p : points) {
      if (model::Contains(standing[0].shape, standing[0].X_WG, p)) nearest = -1;
      for (std::size_t i = 0; i < others.size(); i += 7)
        nearest = std::min(nearest, (p - others[i]).norm());
    }
    CHECK(nearest > 0);
    CHECK(nearest >= clear);
  }
}

TEST_CASE("random tries stand freely, and those that are blocked are") {
  std::mt19937 random(2);
  int counts[2] = {0, 0};
  for (int scene = 0; scene < harness::Effort(20); ++scene) {
    Table table;
    if (scene % 2 == 1) table.region.type = model::RegionType::kDisc;
    if (scene % 2 == 1) table.region.half_size = {0.3, 0.3};
    for (int i = 0; i < 20; ++i) {
      const int body = table.scene.Add(AnyShape(random));
      const PlaceTry where = AnyTry(table, random);
      const PlaceResult result = table.Place(body, where);
      const bool stands = result.verdict == PlaceVerdict::kStands;
      REQUIRE((stands || result.verdict == PlaceVerdict::kBlocked));
      ++counts[stands ? 0 : 1];
      if (stands) {
        CheckStands(table, body, where.clear, random);
        continue;
      }
      const auto& object = table.scene.object;
      const auto own = ShapesAt(ShapesBelow(object, body), result.X_SupportBody);
      const auto other =
          ShapesAt(ShapesBelow(object, result.blocker), PoseInWorld(object, result.blocker));
      CHECK(LargestGap(own[0], other[0], random) < std::max(where.clear, 1e-9));
    }
  }
  CHECK(counts[0] > harness::Effort(120));
  CHECK(counts[1] > harness::Effort(40));
}

}  // namespace
}  // namespace mjforge::placing
