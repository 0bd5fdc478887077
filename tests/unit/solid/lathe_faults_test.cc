// Tests of the faults that lathes report for profiles and walls.

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "mjforge/solid/solid.h"

namespace mjforge::solid {
namespace {

/// Returns "2: is beyond the axis", with points counted from 0, or "ok".
std::string FaultOf(const Lathe& lathe) {
  Fault fault;
  if (Make(lathe, fault)) return "ok";
  return fault.point ? fmt::format("{}: {}", *fault.point, fault.message) : fault.message;
}

TEST_CASE("profiles that make no solid are told why, at the point") {
  CHECK(FaultOf({.profile = {{0, 0}, {1, 0}, {-0.5, 1}}}) == "2: is beyond the axis: r is -0.5 m");
  CHECK(FaultOf({.profile = {{0, 0}, {1, 0}, {1, 0}, {1, 1}}}) ==
        "2: is at the same place as the point before it");
  CHECK(FaultOf({.profile = {{0, 0}, {1, 0}, {1, 1}, {0, 0}}}) ==
        "0: is at the same place as the point before it");
  CHECK(FaultOf({.profile = {{1, 0}, {2, 1}, {2, 0}, {1, 1}}}) ==
        "2: begins a line that crosses or touches the one from point 1 to point 2");
  CHECK(FaultOf({.profile = {{1, 0}, {3, 0}, {2, 0}, {2, 1}}}) ==
        "1: turns back on the line before it");
  CHECK(FaultOf({.profile = {{1, 0}, {2, 0}, {3, 0}}}) == "has no area");
  CHECK(FaultOf({.profile = {{1, 0}, {2, 0}}}) == "needs at least 3 points");
  CHECK(FaultOf({.profile = {}}) == "needs at least 3 points");
  CHECK(FaultOf({.profile = {{1, -1}, {2, -1}, {2, 1}, {1, 1}, {0, 0}}}) ==
        "4: touches the axis without following it");
  CHECK(FaultOf({.profile = std::vector<Eigen::Vector2d>(1001, Eigen::Vector2d(1, 1))}) ==
        "has 1001 points, more than 1000");
}

TEST_CASE("walls that do not fit are told why, at the point") {
  CHECK(FaultOf({.profile = {{0, 0}, {1, 0}, {1, 4}}, .wall = 1.2}) ==
        "2: is 1 m from the axis: a wall of 1.2 m is thicker");
  CHECK(FaultOf({.profile = {{0, 0}, {1, 0}}, .wall = 0.1}) ==
        "has no inside: it is flat; give a closed outline without `wall`");
  CHECK(FaultOf({.profile = {{0, 0}, {5, 0}, {5, 1}, {4.5, 1}, {4.5, 0.5}}, .wall = 0.4}) != "ok");
  CHECK(FaultOf({.profile = {{0, 0}, {5, 0}, {5, 1}}, .wall = 0.4}) == "ok");
}

TEST_CASE("what is small, large, thin or nearly on the axis is a solid") {
  for (const double scale : {1e-6, 1e-3, 1.0, 1e3}) {
    CAPTURE(scale);
    Lathe cup = {.profile = {{0, 0}, {scale, 0}, {scale, 2 * scale}}, .wall = 0.01 * scale};
    CHECK(FaultOf(cup) == "ok");
    Lathe arc;  // with the rounding errors of a computed arc
    for (int i = 0; i <= 8; ++i) {
      const double turn = M_PI * (i / 8.0 - 0.5);
      arc.profile.emplace_back(scale * std::cos(turn), scale * std::sin(turn));
    }
    CHECK(FaultOf(arc) == "ok");
  }
}

TEST_CASE("a profile of a thousand points is made") {
  Lathe ring;
  for (int i = 0; i < 1000; ++i) {
    const double turn = 2 * M_PI * i / 1000;
    ring.profile.emplace_back(2 + std::cos(turn), std::sin(turn));
  }
  ring.facets = 3;
  Fault fault;
  const auto solid = Make(ring, fault);
  REQUIRE(solid);
  CHECK(solid->pieces.size() == 1);
  const double area = 500 * std::sin(2 * M_PI / 1000);
  CHECK(solid->mass.volume == Approx(2 * M_PI * 2 * area).epsilon(1e-9));
}

}  // namespace
}  // namespace mjforge::solid
