// Tests of the cache of solids.

#include "mjforge/solid/solid.h"

#include <catch2/catch.hpp>

namespace mjforge::solid {
namespace {

Lathe Cup(double radius) {
  return {.profile = {{0, 0}, {radius, 0}, {radius, 0.1}}, .wall = 0.002};
}

TEST_CASE("a solid is made once for shapes that are equal in all that they state") {
  Cache cache;
  Fault fault;
  const auto cup = cache.Make(Cup(0.04), fault);
  REQUIRE(cup != nullptr);
  CHECK(cup->pieces.size() == Make(Cup(0.04), fault)->pieces.size());
  CHECK(cup->render_mesh.vertices == Make(Cup(0.04), fault)->render_mesh.vertices);
  CHECK(cache.Make(Cup(0.04), fault) == cup);
  CHECK(cache.Make(Cup(0.0400001), fault) != cup);
  Lathe other = Cup(0.04);
  other.texture.repeat.x() = 2;
  CHECK(cache.Make(other, fault) != cup);
  CHECK(cache.Make(Cup(0.04), fault) == cup);
}

TEST_CASE("shapes of two kinds with the same numbers are two solids") {
  Cache cache;
  Fault fault;
  const auto hull =
      cache.Make(ConvexHull{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, fault);
  const auto box = cache.Make(RoundedBox{.half = {1, 1, 1}, .round = 0.1}, fault);
  REQUIRE(hull != nullptr);
  REQUIRE(box != nullptr);
  CHECK(hull != box);
}

TEST_CASE("a faulty shape gives its fault each time it is asked for") {
  Cache cache;
  for (int i = 0; i < 2; ++i) {
    Fault fault;
    CHECK(cache.Make(Cup(0), fault) == nullptr);
    CHECK_FALSE(fault.message.empty());
  }
}

TEST_CASE("a solid stays whole when the cache has no room for it anymore") {
  Cache cache;
  Fault fault;
  const auto first = cache.Make(Cup(0.04), fault);
  const auto vertices = first->render_mesh.vertices;
  for (int i = 1; i < 100; ++i) REQUIRE(cache.Make(Cup(0.04 + 1e-4 * i), fault) != nullptr);
  CHECK(first->render_mesh.vertices == vertices);
  CHECK(first.use_count() == 1);
  CHECK(cache.Make(Cup(0.04), fault)->render_mesh.vertices == vertices);
}

}  // namespace
}  // namespace mjforge::solid
