// Tests of sites.

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

TEST_CASE("sites have MuJoCo's defaults for what is left out") {
  const Assembling thing(
      "parts: [{name: a, type: sphere, size: [1]}]\n"
      "sites:\n"
      "- {name: p}\n"
      "- {name: q, type: box, size: [0.1, 0.2], pos: [1, 2, 3], rgba: [1, 0, 0, 1]}\n"
      "- {name: 'r${i}', for: {i: 2}, if: i > 0}\n");
  const std::vector<model::Site>& sites = thing.body().sites;
  REQUIRE(sites.size() == 3);
  CHECK(sites[0].type == model::GeomType::kSphere);
  CHECK(sites[0].size == Eigen::Vector3d(0.005, 0.005, 0.005));
  CHECK(sites[1].type == model::GeomType::kBox);
  CHECK(sites[1].size == Eigen::Vector3d(0.1, 0.2, 0.005));
  CHECK(sites[1].X_BS.p == Eigen::Vector3d(1, 2, 3));
  CHECK(model::FindAttribute(sites[1].attributes, "rgba")->numbers == sample::Numbers{1, 0, 0, 1});
  CHECK(sites[2].name == "thing_r1");
}

TEST_CASE("a site's default attributes fill gaps") {
  const Assembling thing(
      "defaults: {site: {group: 3, size: 0.01}}\n"
      "parts: [{name: a, type: sphere, size: [1]}]\n"
      "sites: [{name: p, group: 1}, {name: q}]\n");
  CHECK(model::FindAttribute(thing.body().sites.at(0).attributes, "group")->numbers ==
        sample::Numbers{1});
  CHECK(model::FindAttribute(thing.body().sites.at(1).attributes, "group")->numbers ==
        sample::Numbers{3});
  CHECK(thing.body().sites.at(1).size.x() == 0.01);
}

}  // namespace
}  // namespace mjforge::assemble
