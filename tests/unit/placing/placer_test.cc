// Tries of places: poses in closed form, and verdicts.
#include <catch2/catch.hpp>
#include <cmath>

#include "mjforge/placing/placing.h"
#include "table.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::GeomType;
using model::PlaceResult;
using model::PlaceTry;
using model::PlaceVerdict;
using model::Pose;
using model::Region;

// Returns the angle of a body's x axis.
double YawOf(const PlaceResult& result) {
  const Vector3d x = result.X_SupportBody.q * Vector3d::UnitX();
  return std::atan2(x.y(), x.x());
}

void CheckAt(const PlaceResult& result, const Vector3d& p, double tolerance = 1e-8) {
  CAPTURE(result.X_SupportBody.p.transpose(), p.transpose());
  CHECK(result.verdict == PlaceVerdict::kStands);
  CHECK((result.X_SupportBody.p - p).norm() < tolerance);
}

TEST_CASE("a body stands on a region, in contact with its support") {
  Table table;
  const int can = table.scene.Add(ShapeOf(GeomType::kCylinder, 0.05, 0.1));
  CheckAt(table.Place(can, table.Where(1, -1)), {0.45, -0.25, 0.1 - kContactDepth});
}

TEST_CASE("a body stands a little above a region that has no support") {
  Table table;
  const int can = table.scene.Add(ShapeOf(GeomType::kCylinder, 0.05, 0.1));
  table.placer->Begin(table.scene.object);
  CheckAt(table.placer->Try(can, table.Where()), {0, 0, 0.1 + kContactGap});
}

TEST_CASE("a box stands on a box, a little above it") {
  Table table;
  const int box = table.AddBox(0.1, 0.05, 0.2);
  PlaceTry where = table.Where(1, -1);
  const PlaceResult result = table.Place(box, where);
  CheckAt(result, {0.4, -0.25, 0.2 + kContactGap});
  CHECK(result.footprint.isApprox(Vector2d(0.2, 0.1)));
  // Turned, and on a table that is turned and moved itself.
  table.scene.body(table.table).X_PB = At(1, 2, 3, 0.5);
  table.placer->Begin(table.scene.object);
  table.placer->AddObstacle(table.table);
  where.yaw = M_PI / 2;
  CheckAt(table.placer->Try(box, where), {0.45, -0.2, 0.2 + kContactGap});
}

TEST_CASE("bodies below a body are placed with it, at their start state") {
  Table table;
  const int box = table.AddBox(0.1, 0.05, 0.2);
  // An arm that starts turned down by a quarter turn.
  table.scene.Add(ShapeOf(GeomType::kBox, 0.01, 0.01, 0.01), At(0, 0, -0.1), box);
  table.scene.object.bodies.back().parts.back().X_BG = At(0.2, 0, 0);
  model::Joint& joint = table.scene.object.bodies.back().joints.emplace_back();
  joint.type = "hinge";
  joint.axis = Vector3d::UnitY();
  joint.start = {M_PI / 2};
  const PlaceResult result = table.Place(box, table.Where());
  CheckAt(result, {0, 0, 0.31 + kContactGap});
  CHECK((result.footprint - Vector2d(0.02, 0.02)).norm() < 1e-9);
}

TEST_CASE("a body in another orientation stands on another side") {
  Table table;
  const int box = table.AddBox(0.1, 0.05, 0.2);
  PlaceTry where = table.Where(1, 1);
  where.lying = model::FromAxisAngle(Vector3d::UnitY(), M_PI / 2);
  CheckAt(table.Place(box, where), {0.3, 0.25, 0.1 + kContactGap});
}

TEST_CASE("a place can be too small, too low, outside or taken") {
  Table table;
  CHECK(table.Place(table.AddBox(0.51, 0.1, 0.1), table.Where()).verdict ==
        PlaceVerdict::kTooLarge);
  table.region.height = 0.2;
  CHECK(table.Place(table.AddBox(0.1, 0.1, 0.1), table.Where()).verdict == PlaceVerdict::kTooHigh);
  const int low = table.AddBox(0.1, 0.1, 0.0999);
  CHECK(table.Place(low, table.Where()).verdict == PlaceVerdict::kStands);
  const int second = table.AddBox(0.1, 0.1, 0.05);
  const PlaceResult result = table.Place(second, table.Where(0.4));
  CHECK(result.verdict == PlaceVerdict::kBlocked);
  CHECK(result.blocker == low);
  CHECK(result.distance == 0);
  PlaceTry where = table.Where();
  where.beside = {.body = low, .gap = 0.21};
  CHECK(table.Place(second, where).verdict == PlaceVerdict::kOutside);
  where.beside->gap = 0.2 - 1e-9;
  CheckAt(table.Place(second, where), {-0.4, 0, 0.05 + kContactGap}, 1e-7);
}

TEST_CASE("a body stands at a gap beside another, as that body's front says") {
  Table table;
  const int first = table.AddBox(0.05, 0.03, 0.05);
  PlaceTry where = table.Where();
  table.Place(first, where);
  const int second = table.AddBox(0.02, 0.01, 0.05);
  const auto at = [&](model::Side side, double front, const Vector2d& uv) {
    PlaceTry beside = table.Where(uv.x(), uv.y());
    beside.beside = model::Beside{first, side, front, 0.02};
    table.placer->Begin(table.scene.object);
    return table.placer->Try(second, beside);
  };
  const double z = 0.05 + kContactGap;
  using enum model::Side;
  CheckAt(at(kRight, 0, {0, 0}), {-0.09, 0, z});
  CheckAt(at(kLeft, 0, {0, 1}), {0.09, 0.02, z});
  CheckAt(at(kFront, 0, {-1, 0}), {-0.03, -0.06, z});
  CheckAt(at(kBack, 0, {0, 0}), {0, 0.06, z});
  // The front of the first is +x, so that its right is -y, and the second is turned like it.
  const PlaceResult turned = at(kRight, M_PI / 2, {0, 0});
  CheckAt(turned, {0, -0.03 - 0.02 - 0.02, z});
  CHECK(std::abs(YawOf(turned) - M_PI / 2) < 1e-9);
}

TEST_CASE("bodies beside each other without a gap do not overlap") {
  Table table;
  const int first = table.AddBox(0.05, 0.03, 0.05);
  table.Place(first, table.Where());
  PlaceTry beside = table.Where(0, 0);
  beside.beside = model::Beside{first, model::Side::kRight, 0.3, 0};
  CHECK(table.placer->Try(table.AddBox(0.02, 0.01, 0.05), beside).verdict == PlaceVerdict::kStands);
}

TEST_CASE("a stack may touch a body below that asks for distance") {
  Table table;
  Region top = BoxRegion(0.02, 0.02, 0.002);
  top.margin = -0.1;
  const int lowest = table.AddBox(0.05, 0.05, 0.002);
  table.scene.AddPart(ShapeOf(GeomType::kBox, 0.002, 0.05, 0.05), At(0.07, 0, 0.05));  // a wall
  table.Place(lowest, table.Where(), 0.03);
  int below = lowest;
  for (int i = 0; i < 2; ++i) {
    table.scene.body(below).place_name = "below";
    PlaceTry where = table.Where();
    where.support = below;
    where.region = &top;
    const int body = table.AddBox(0.05, 0.05, 0.002);
    table.scene.body(body).parent = below;
    CHECK(table.Place(body, where).verdict == PlaceVerdict::kStands);
    below = body;
  }
}

TEST_CASE("the front of a body faces a point or looks along a direction") {
  Table table;
  const int box = table.AddBox(0.05, 0.02, 0.05);
  PlaceTry where = table.Where(0.7, -0.3);
  where.facing = Vector2d(0.1, 0.2);
  where.front = GENERATE(0.0, 1.0);
  where.yaw = GENERATE(0.0, 0.25);
  const PlaceResult result = table.Place(box, where);
  const Vector2d way = *where.facing - result.X_SupportBody.p.head<2>();
  const double wanted = std::atan2(way.x(), -way.y()) - where.front + where.yaw;
  CHECK(std::abs(std::remainder(YawOf(result) - wanted, 2 * M_PI)) < 1e-9);
  where.facing.reset();
  where.direction = Vector2d(2, 0);
  table.placer->Begin(table.scene.object);
  CHECK(YawOf(table.placer->Try(box, where)) ==
        Approx(M_PI / 2 - where.front + where.yaw).margin(1e-9));
}

TEST_CASE("a body in an interior is lowered until it touches") {
  Scene scene;
  const int outer = scene.AddBin(0.2, 0.1, 0.01);
  const int inner = scene.AddBin(0.15, 0.1, 0.01);
  const int ball = scene.Add(ShapeOf(GeomType::kSphere, 0.05));
  Region region = BoxRegion(0.2, 0.2);
  region.has_walls = true;
  region.height = GENERATE(std::numeric_limits<double>::infinity(), 0.3);
  const auto placer = MakePlacer();
  placer->Begin(scene.object);
  placer->AddObstacle(outer);
  PlaceTry where;
  where.support = outer;
  where.region = &region;
  where.clear = 0.03;
  PlaceResult result = placer->Try(inner, where);
  CheckAt(result, {0, 0, 0.01 + kContactGap}, 1e-6);
  scene.body(inner).X_PB = result.X_SupportBody;
  placer->AddObstacle(inner);
  // In the inner bin, whose floor is 1 cm above that of the outer one.
  Region inside = BoxRegion(0.15, 0.15);
  inside.has_walls = true;
  where.support = inner;
  where.region = &inside;
  result = placer->Try(ball, where);
  CheckAt(result, {0, 0, 0.05 - kContactDepth}, 1e-6);
  // The ball's foot is in the region, but the ball would lie on the wall, from which it would roll.
  where.clear = 0;
  where.uv = Vector2d(1, 0);
  result = placer->Try(ball, where);
  CHECK(result.verdict == PlaceVerdict::kBlocked);
  CHECK(result.blocker == inner);
}

/// Tries to place a body in the middle of an interior of a bin, as wide as twice `half`.
PlaceResult PlaceInside(const Scene& scene, int bin, double half, int body) {
  Region region = BoxRegion(half, half);
  region.has_walls = true;
  const auto placer = MakePlacer();
  placer->Begin(scene.object);
  placer->AddObstacle(bin);
  PlaceTry where;
  where.support = bin;
  where.region = &region;
  return placer->Try(body, where);
}

TEST_CASE("a body that would hang on a wall by its end does not stand") {
  Scene scene;
  const int bin = scene.AddBin(0.2, 0.05, 0.01);
  const int pan = scene.Add(ShapeOf(GeomType::kBox, 0.05, 0.05, 0.05));
  const double handle_z = GENERATE(-0.03, 0.03);  // below and above the rim of the bin
  scene.AddPart(ShapeOf(GeomType::kBox, 0.1, 0.01, 0.01), At(0.15, 0, handle_z));
  const PlaceResult result = PlaceInside(scene, bin, 0.2, pan);
  if (handle_z > 0) {
    CheckAt(result, {0, 0, 0.05 + kContactGap}, 1e-6);
  } else {
    CHECK(result.verdict == PlaceVerdict::kBlocked);
    CHECK(result.blocker == bin);
  }
}

TEST_CASE("a plate that lies on one wall with its edge does not stand") {
  Scene scene;
  const int bin = scene.AddBin(0.2, 0.05, 0.01);
  const int pan = scene.Add(ShapeOf(GeomType::kBox, 0.05, 0.05, 0.05));
  // The plate's faces contain the middle of the body, but only its end is above a wall.
  scene.AddPart(ShapeOf(GeomType::kBox, 0.175, 0.1, 0.01), At(0.075, 0, -0.03));
  const PlaceResult result = PlaceInside(scene, bin, 0.2, pan);
  CHECK(result.verdict == PlaceVerdict::kBlocked);
  CHECK(result.blocker == bin);
}

TEST_CASE("a body lies across two walls if its middle is between them") {
  Scene scene;
  const int bin = scene.AddBin(0.2, 0.05, 0.01);
  const int board = scene.Add(ShapeOf(GeomType::kBox, 0.25, 0.05, 0.01));
  CheckAt(PlaceInside(scene, bin, 0.3, board), {0, 0, 0.06 + kContactGap}, 1e-6);
}

TEST_CASE("a body stands below the lid of an interior that states no height") {
  Scene scene;
  const int bin = scene.AddBin(0.2, 0.1, 0.01);
  const double lid = GENERATE(0.12, 0.123, 0.1371);  // height of its middle
  scene.AddPart(ShapeOf(GeomType::kBox, 0.21, 0.21, 0.01), At(0, 0, lid));
  const double half = GENERATE(0.04, 0.041, 0.07);
  const int box = scene.Add(ShapeOf(GeomType::kBox, half, half, half));
  // The largest box has no room below the lid.
  const double floor = half < 0.05 ? 0 : lid + 0.01;
  for (int i = 0; i < 20; ++i) {  // rounding does not decide
    scene.body(bin).X_PB = At(0, 0, 0.01 * i);
    CheckAt(PlaceInside(scene, bin, 0.2, box), {0, 0, floor + half + kContactGap}, 1e-6);
  }
}

TEST_CASE("round bowls nest") {
  Scene scene;
  // A floor, and a ring of boxes that lean outwards.
  std::vector<int> bowls;
  for (int i = 0; i < 2; ++i) {
    bowls.push_back(scene.Add(ShapeOf(GeomType::kCylinder, 0.05, 0.002)));
    for (int k = 0; k < 16; ++k) {
      Pose tilted = At(0, 0, 0, 2 * M_PI * k / 16) *
                    Pose{{0.085, 0, 0.035}, model::FromAxisAngle(-Vector3d::UnitY(), M_PI / 4)};
      scene.AddPart(ShapeOf(GeomType::kBox, 0.045, 0.01, 0.002), tilted);
    }
  }
  Region inside = BoxRegion(0.052, 0.052, 0.002);
  inside.type = model::RegionType::kDisc;
  inside.has_walls = true;
  const auto placer = MakePlacer();
  placer->Begin(scene.object);
  placer->AddObstacle(bowls[0]);
  PlaceTry where;
  where.support = bowls[0];
  where.region = &inside;
  const PlaceResult result = placer->Try(bowls[1], where);
  CHECK(result.verdict == PlaceVerdict::kStands);
  // Walls of 4 mm at 45 degrees touch at a rise of 4 mm times sqrt(2), above the floors' 4 mm.
  CheckAt(result, {0, 0, 0.004 * std::sqrt(2) + kContactGap}, 1e-6);
}

TEST_CASE("the sites of a body and its support coincide") {
  Scene scene;
  const int board = scene.Add(ShapeOf(GeomType::kBox, 0.5, 0.01, 0.5), At(0, 0, 1, 0.3));
  const int tool = scene.Add(ShapeOf(GeomType::kBox, 0.02, 0.02, 0.1));
  const auto placer = MakePlacer();
  placer->Begin(scene.object);
  placer->AddObstacle(board);
  PlaceTry where;
  where.support = board;
  where.X_SupportSite = At(0.1, -0.04, 0.2);
  where.X_BodySite = At(0, 0, 0.09);
  const PlaceResult result = placer->Try(tool, where);
  CheckAt(result, {0.1, -0.04, 0.11});
  // The support may overlap, for bodies touch at their sites; others may not.
  where.X_SupportSite.p.y() = -0.02;
  CHECK(placer->Try(tool, where).verdict == PlaceVerdict::kStands);
  scene.body(tool).X_PB = At(0, 0, 1, 0.3) * result.X_SupportBody;
  placer->AddObstacle(tool);
  const int second = scene.Add(ShapeOf(GeomType::kBox, 0.02, 0.02, 0.1));
  CHECK(placer->Try(second, where).verdict == PlaceVerdict::kBlocked);
  CHECK(placer->Try(second, where).blocker == tool);
}

TEST_CASE("a body that tips over as modelled stands in the nearest stable pose") {
  Table table;
  // A spoon: a bowl, and a handle that is higher.
  const int spoon = table.scene.Add(ShapeOf(GeomType::kSphere, 0.02));
  table.scene.AddPart(ShapeOf(GeomType::kBox, 0.1, 0.005, 0.001), At(0.12, 0, 0.015));
  const PlaceResult result = table.Place(spoon, table.Where());
  REQUIRE(result.verdict == PlaceVerdict::kStands);
  // Its lowest points are those of bowl and handle: the handle's end went down.
  const Pose& X = result.X_SupportBody;
  CHECK((X * Vector3d(0.22, 0, 0.014)).z() == Approx(kContactGap).margin(2e-4));
  CHECK(X.p.z() == Approx(0.02 + kContactGap).margin(2e-4));
  CHECK(result.footprint.x() > 0.2);
  // Facing and front are meant for the spoon as it lies.
  PlaceTry where = table.Where();
  where.front = M_PI / 2;
  where.direction = Vector2d(0, 1);
  table.placer->Begin(table.scene.object);
  const Vector3d handle = table.placer->Try(spoon, where).X_SupportBody.q * Vector3d::UnitX();
  CHECK(std::abs(handle.x()) < 1e-9);
  CHECK(handle.y() > 0.9);
}

TEST_CASE("a body does not stand on an apex or a rounded end") {
  Table table;
  const int pen = table.scene.Add(ShapeOf(GeomType::kCapsule, 0.004, 0.07));
  CHECK(table.Place(pen, table.Where()).size.z() == Approx(0.008));
  // A spike below a disc: it tips over to the disc's rim.
  const int top = table.scene.Add(ShapeOf(GeomType::kCylinder, 0.04, 0.002), At(0, 0, 0.05));
  auto& parts = table.scene.body(top).parts;
  parts.push_back(parts.front());
  parts.back().shape = ShapeOf(GeomType::kEllipsoid, 0.003, 0.003, 0.04);
  parts.back().X_BG = At(0, 0, -0.04);
  CHECK(std::abs((table.Place(top, table.Where()).X_SupportBody.q * Vector3d::UnitZ()).z()) < 0.9);
}

TEST_CASE("a round body keeps the modelled orientation") {
  Table table;
  const int ball = table.scene.Add(ShapeOf(GeomType::kSphere, 0.05));
  CheckAt(table.Place(ball, table.Where()), {0, 0, 0.05 - kContactDepth});
  const int egg = table.scene.Add(ShapeOf(GeomType::kEllipsoid, 0.05, 0.05, 0.03));
  CHECK(table.Place(egg, table.Where()).X_SupportBody.q.w() == 1);
}

TEST_CASE("a body tips onto a part that is less than a millimetre above the ground") {
  Table table;
  // A grip, and a collar whose lower face is 0.5 mm higher; the centre of mass is between them.
  const int driver = table.scene.Add(ShapeOf(GeomType::kBox, 0.005, 0.01, 0.01));
  table.scene.AddPart(ShapeOf(GeomType::kBox, 0.02, 0.0095, 0.0095), At(0.1, 0, 0));
  const PlaceResult result = table.Place(driver, table.Where());
  REQUIRE(result.verdict == PlaceVerdict::kStands);
  const Vector3d axis = result.X_SupportBody.q * Vector3d::UnitX();
  CHECK(axis.z() == Approx(-0.0005 / 0.115).epsilon(0.01));
}

TEST_CASE("the distance that a standing body asks for holds for later ones") {
  Table table;
  table.Place(table.AddBox(0.05, 0.05, 0.05), table.Where(), 0.03);
  const int second = table.AddBox(0.05, 0.05, 0.05);
  const double play = 0.45;
  CHECK(table.Place(second, table.Where(0.129 / play)).verdict == PlaceVerdict::kBlocked);
  CHECK(table.Place(second, table.Where(0.131 / play)).verdict == PlaceVerdict::kStands);
}

}  // namespace
}  // namespace mjforge::placing
