// Groups of parts that touch, and the nearest part outside a group.
#include "mjforge/static_checks/connected_parts.h"

#include <catch2/catch.hpp>
#include <list>

namespace mjforge::static_checks {
namespace {

using model::GeomType;

/// Parts at positions, in the order in which they are added.
class Scene {
 public:
  void Add(GeomType type, const Eigen::Vector3d& size, const Eigen::Vector3d& pos) {
    model::Part& part = parts_.emplace_back();
    part.shape = {type, size, nullptr};
    part.mass = model::Volume(part.shape);
    model::Pose pose;
    pose.p = pos;
    placed_.emplace_back(&part, pose);
  }

  const std::vector<PlacedPart>& placed() const { return placed_; }

 private:
  std::list<model::Part> parts_;
  std::vector<PlacedPart> placed_;
};

TEST_CASE("parts are connected up to the gap between their surfaces") {
  const double scale = GENERATE(1e-4, 1.0, 100.0);
  CAPTURE(scale);
  const std::pair<GeomType, Eigen::Vector3d> others[] = {{GeomType::kSphere, {0.5, 0, 0}},
                                                         {GeomType::kBox, {0.5, 2, 3}},
                                                         {GeomType::kCylinder, {0.5, 1, 0}},
                                                         {GeomType::kCapsule, {0.5, 1, 0}},
                                                         {GeomType::kEllipsoid, {0.5, 2, 1}}};
  for (const auto& [type, size] : others) {
    CAPTURE(model::GeomTypeName(type));
    Scene scene;
    scene.Add(GeomType::kSphere, {scale, 0, 0}, {0, 0, 0});
    scene.Add(type, scale * size, {scale * 1.6, 0, 0});
    CHECK(ConnectedGroups(scene.placed(), 0.0999 * scale).size() == 2);  // the parts are 0.1 apart
    CHECK(ConnectedGroups(scene.placed(), 0.1001 * scale).size() == 1);
  }
}

TEST_CASE("a part inside another is connected to it") {
  Scene scene;
  scene.Add(GeomType::kBox, {1, 1, 1}, {0, 0, 0});
  scene.Add(GeomType::kSphere, {0.1, 0, 0}, {0, 0, 0});
  CHECK(ConnectedGroups(scene.placed(), 1e-6).size() == 1);
}

TEST_CASE("the heaviest group comes first") {
  Scene scene;
  scene.Add(GeomType::kBox, {1, 1, 1}, {10, 0, 0});
  scene.Add(GeomType::kBox, {2, 1, 1}, {0, 0, 0});
  scene.Add(GeomType::kBox, {1, 1, 1}, {-3, 0, 0});
  scene.Add(GeomType::kSphere, {0.1, 0, 0}, {-4.1, 0, 0});
  CHECK(ConnectedGroups(scene.placed(), 0.001) == std::vector<PartGroup>{{1, 2, 3}, {0}});
  CHECK(ConnectedGroups(scene.placed(), 7.1).size() == 1);
}

TEST_CASE("the nearest part outside a group, and how far it is") {
  Scene scene;
  scene.Add(GeomType::kBox, {1, 1, 1}, {0, 0, 0});
  scene.Add(GeomType::kSphere, {1, 0, 0}, {10, 0, 0});
  scene.Add(GeomType::kBox, {1, 1, 1}, {5, 0, 0});
  const NearestPart nearest = NearestOutside(scene.placed(), {0, 1});
  CHECK(nearest.index == 2);
  CHECK(nearest.distance == Approx(3));
}

}  // namespace
}  // namespace mjforge::static_checks
