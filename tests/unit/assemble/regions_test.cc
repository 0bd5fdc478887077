// Tests of regions: declared ones, their checks, names and sites.

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

const char* const kBlock = "parts: [{name: a, type: box, size: [1, 1, 1]}]\n";

TEST_CASE("regions have a level frame, a size, and a site of group 5") {
  const Assembling thing(
      std::string(kBlock) +
      "regions:\n"
      "- {name: top, size: [0.5, 0.25], pos: [0, 0, 1], euler: [0, 0, 90deg]}\n"
      "- {name: bowl, type: disc, size: 0.3, height: 0.2, margin: 1cm, clear: 2cm,\n"
      "   walls: true}\n");
  const std::vector<model::Region>& regions = thing.body().regions;
  REQUIRE(regions.size() == 2);
  CHECK(regions[0].name == "top");
  CHECK(regions[0].site == "thing_top");
  CHECK(regions[0].type == model::RegionType::kBox);
  CHECK(regions[0].half_size == Eigen::Vector2d(0.5, 0.25));
  CHECK(regions[0].X_BR.p == Eigen::Vector3d(0, 0, 1));
  CHECK((regions[0].X_BR.q * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm() < 1e-12);
  CHECK(std::isinf(regions[0].height));
  CHECK_FALSE(regions[0].has_walls);
  CHECK(regions[1].type == model::RegionType::kDisc);
  CHECK(regions[1].half_size == Eigen::Vector2d(0.3, 0.3));
  CHECK(regions[1].height == 0.2);
  CHECK(regions[1].margin == 0.01);
  CHECK(regions[1].clear == 0.02);
  CHECK(regions[1].has_walls);
  const std::vector<model::Site>& sites = thing.body().sites;
  REQUIRE(sites.size() == 2);
  CHECK(sites[0].name == "thing_top");
  CHECK(sites[0].type == model::GeomType::kBox);
  CHECK(sites[0].size == Eigen::Vector3d(0.5, 0.25, 0.0005));
  CHECK(sites[0].X_BS.p == Eigen::Vector3d(0, 0, 1));
  CHECK(model::FindAttribute(sites[0].attributes, "group")->numbers == sample::Numbers{5});
  CHECK(sites[1].type == model::GeomType::kCylinder);
  CHECK(sites[1].size.head<2>() == Eigen::Vector2d(0.3, 0.0005));
}

TEST_CASE("polygons become counter-clockwise, with the origin in the middle") {
  const Assembling thing(std::string(kBlock) +
                         "regions: [{name: p, type: polygon, pos: [1, 1, 1],\n"
                         "  polygon: [[0, 0], [0, 0.4], [0.2, 0]]}]\n");
  const model::Region& region = thing.body().regions.at(0);
  CHECK(region.half_size == Eigen::Vector2d(0.1, 0.2));
  CHECK(region.X_BR.p.isApprox(Eigen::Vector3d(1.1, 1.2, 1)));
  REQUIRE(region.corners.size() == 3);
  CHECK(region.corners[0].isApprox(Eigen::Vector2d(0.1, -0.2)));
  CHECK(region.corners[1].isApprox(Eigen::Vector2d(-0.1, 0.2)));
  CHECK(region.corners[2].isApprox(Eigen::Vector2d(-0.1, -0.2)));
  CHECK(thing.body().sites.at(0).size == Eigen::Vector3d(0.1, 0.2, 0.0005));
}

TEST_CASE("regions repeat, and are named after the body of their entry") {
  const Assembling thing(
      "bodies:\n"
      "- name: rack\n"
      "  parts: [{name: a, type: box, size: [1, 1, 1]}]\n"
      "  regions:\n"
      "  - {name: 'slot_${i}', for: {i: 3}, if: i > 0, size: [1cm, 1cm], pos: [i, 0, 1]}\n");
  const std::vector<model::Region>& regions = thing.object().bodies.at(1).regions;
  REQUIRE(regions.size() == 2);
  CHECK(regions[0].name == "slot_1");
  CHECK(regions[1].site == "thing_rack_slot_2");
  CHECK(regions[1].X_BR.p == Eigen::Vector3d(2, 0, 1));
}

TEST_CASE("regions of nested and welded specs have their prefixes and poses") {
  TemporaryFolder folder;
  folder.Write("tray.yaml",
               "{mjforge: 1, name: tray, parts: [{name: a, type: box, size: [1, 1, 1]}],\n"
               " regions: [{name: surface, size: [1, 1], pos: [0, 0, 1]}]}");
  const Assembling thing(
      "parts: [{name: low, spec: tray.yaml, pos: [0, 0, 3]}]\n"
      "bodies: [{name: high, spec: tray.yaml, pos: [0, 0, 6]}]\n",
      1, 0, folder.path());
  const model::Region& low = thing.body().regions.at(0);
  CHECK(low.site == "thing_low_surface");
  CHECK(low.name == "surface");
  CHECK(low.X_BR.p == Eigen::Vector3d(0, 0, 4));
  CHECK(thing.object().bodies.at(1).regions.at(0).site == "thing_high_surface");
  CHECK(thing.object().bodies.at(1).regions.at(0).X_BR.p == Eigen::Vector3d(0, 0, 1));
}

TEST_CASE("a corner placement moves regions with their spec") {
  TemporaryFolder folder;
  folder.Write("tray.yaml",
               "{mjforge: 1, name: tray, parts: [{name: a, type: box, size: [1, 1, 1]}],\n"
               " regions: [{name: surface, size: [1, 1], pos: [0, 0, 1]}]}");
  const Assembling thing(
      "placement: corner\n"
      "total_size: [2, 2, 2]\n"
      "parts: [{name: low, spec: tray.yaml, pos: [1, 1, 1]}]\n",
      1, 0, folder.path());
  CHECK(thing.body().regions.at(0).X_BR.p.isApprox(Eigen::Vector3d(0, 0, 1)));
  CHECK(thing.body().sites.at(0).X_BS.p.isApprox(Eigen::Vector3d(0, 0, 1)));
}

TEST_CASE("draws of regions have streams of their own") {
  const std::string body = "parts: [{name: a, type: box, size: [1, 1, 1 .. 2]}]\n";
  const Assembling without(body);
  const Assembling with(body + "regions: [{name: s, size: [0.1 .. 0.9, 0.1], pos: [0, 0, 1]}]\n");
  CHECK(with.part("thing_a").shape.size == without.part("thing_a").shape.size);
  CHECK(with.body().regions.at(0).half_size.x() != 0.1);
}

TEST_CASE("faulty regions are reported") {
  const auto finding = [](const std::string& region) {
    return OnlyFinding(std::string(kBlock) + "regions: [{name: r, " + region + "}]\n");
  };
  CHECK(finding("type: box") == "4:11 region 'r' has no 'size'");
  CHECK(finding("size: [1]") == "4:27 size of region 'r' has 1 number; it must have 2");
  CHECK(finding("type: disc, size: [1, 2]") ==
        "4:39 size of region 'r' has 2 numbers; it must have 1");
  CHECK(finding("size: [0, 1]") == "4:28 size 1 is 0; it must be greater than 0");
  CHECK(finding("size: [1, 1], polygon: [[0, 0]]") ==
        "4:44 polygon of region 'r' has no meaning for a region of type box");
  CHECK(finding("type: auto, walls: true") ==
        "4:40 walls of region 'r' has no meaning for a region of type auto");
  CHECK(finding("type: polygon, polygon: [[0, 0], [1, 0]]") ==
        "4:45 polygon of region 'r' has fewer than three corners");
  CHECK(finding("type: polygon, polygon: [[0, 0], [1, 0], [0.2, 0.2], [0, 1]]") ==
        "4:45 polygon of region 'r' is not convex at its corner 3 (divide it into convex regions)");
  CHECK(finding("type: polygon, polygon: [[0, 0], [1, 1], [1, 0], [0, 1]]").find("is not convex") !=
        std::string::npos);
  CHECK(finding("size: [1, 0.1], margin: 0.1") ==
        "4:45 margin of region 'r' leaves no room in the region");
  CHECK(finding("type: polygon, margin: 0.22, polygon: [[0, 0], [1, 0], [0, 0.6]]") ==
        "4:44 margin of region 'r' leaves no room in the region");
  CHECK(finding("size: [1, 1], height: 0") == "4:43 height is 0; it must be greater than 0");
  CHECK(OnlyFinding(std::string(kBlock) + "regions: autos\n") ==
        "4:10 'autos' is neither 'auto' nor a list of regions");
}

TEST_CASE("two regions of one name are reported") {
  CHECK(OnlyFinding(std::string(kBlock) +
                    "regions: [{name: r, size: [1, 1]}, {name: r, size: [1, 1]}]\n") ==
        "4:43 two regions are named 'r'");
  CHECK(OnlyFinding(std::string(kBlock) + "sites: [{name: r}]\n"
                                          "regions: [{name: r, size: [1, 1]}]\n")
            .find("r") != std::string::npos);
}

TEST_CASE("a region must be level at the start, unless another spec brings it") {
  CHECK(OnlyFinding(std::string(kBlock) +
                    "regions: [{name: r, size: [1, 1], euler: [10deg, 0, 0]}]\n") ==
        "4:11 region 'r' leans by 10 degrees at the start (nothing can stand on it: turn it, or "
        "leave it out by `if`)");
  const std::string lid =
      "bodies:\n"
      "- name: lid\n"
      "  parts: [{name: b, type: box, size: [1, 1, 0.1], pos: [1, 0, 2]}]\n"
      "  joints: [{name: hinge, axis: [0, -1, 0], range: [0, 100deg]}]\n"
      "  regions: [{name: r, size: [1, 1], pos: [1, 0, 2.1]}]\n"
      "pose: {hinge: 45deg}\n";
  CHECK(OnlyFinding(std::string(kBlock) + lid) ==
        "8:13 region 'r' leans by 45 degrees at the start (nothing can stand on it: turn it, or "
        "leave it out by `if`)");
  TemporaryFolder folder;
  folder.Write("box.yaml", "mjforge: 1\nname: box\n" + std::string(kBlock) +
                               "regions: [{name: r, size: [1, 1], pos: [0, 0, 1]}]\n");
  const Assembling thing("bodies: [{name: box, spec: box.yaml, euler: [90deg, 0, 0]}]\n", 1, 0,
                         folder.path());
  CHECK(thing.object().bodies.at(1).regions.size() == 1);
}

TEST_CASE("auto finds the largest level faces first") {
  const Assembling thing(
      "parts:\n"
      "- {name: low, type: box, size: [0.2, 0.1, 0.05], pos: [0, 0, 0.05]}\n"
      "- {name: high, type: cylinder, size: [0.05, 0.1], pos: [-0.15, 0, 0.2]}\n"
      "regions: auto\n");
  const std::vector<model::Region>& regions = thing.body().regions;
  REQUIRE(regions.size() == 2);
  CHECK(regions[0].name == "surface");
  CHECK(regions[0].type == model::RegionType::kBox);
  // The cylinder stands at the left end, and is cut off.
  CHECK(regions[0].half_size.isApprox(Eigen::Vector2d(0.15, 0.1)));
  CHECK(regions[0].X_BR.p.isApprox(Eigen::Vector3d(0.05, 0, 0.1)));
  CHECK(std::isinf(regions[0].height));
  CHECK(regions[1].name == "surface_1");
  CHECK(regions[1].site == "thing_surface_1");
  CHECK(regions[1].type == model::RegionType::kDisc);
  CHECK(regions[1].half_size == Eigen::Vector2d(0.05, 0.05));
  CHECK(regions[1].X_BR.p.isApprox(Eigen::Vector3d(-0.15, 0, 0.3)));
}

TEST_CASE("auto measures the height below other bodies, and keeps the least area and height") {
  const std::string shelves =
      "parts:\n"
      "- {name: 'board_${i}', for: {i: 3}, type: box, size: [0.2, 0.1, 0.01],\n"
      "   pos: [0, 0, 0.01 + 0.3 * i]}\n"
      "- {name: 'side_${i}', for: {i: 2}, type: box, size: [0.005, 0.1, 0.35],\n"
      "   pos: [(i - 0.5) * 0.41, 0, 0.35]}\n"
      "bodies:\n"
      "- {name: lid, pos: [0, 0, 0.72], parts: [{name: c, type: box, size: [0.2, 0.1, 0.005]}]}\n";
  const Assembling thing(shelves + "regions: [{name: shelf, type: auto, margin: 1cm}]\n");
  const std::vector<model::Region>& regions = thing.body().regions;
  REQUIRE(regions.size() == 3);
  CHECK(regions[0].X_BR.p.isApprox(Eigen::Vector3d(0, 0, 0.62)));  // of equal ones, the highest
  CHECK(regions[0].height == Approx(0.095));
  CHECK(regions[0].margin == 0.01);
  CHECK(regions[2].height == Approx(0.28));
  CHECK(regions[2].half_size.isApprox(Eigen::Vector2d(0.2, 0.1)));
  CHECK(Assembling(shelves + "regions: [{name: s, type: auto, height: 20cm}]\n")
            .body()
            .regions.size() == 2);
  CHECK(
      Assembling(shelves + "regions: [{name: s, type: auto, area: 0.1}]\n").body().regions.empty());
}

TEST_CASE("a search that finds nothing is a warning with the largest face") {
  const auto finding = [](const std::string& spec) {
    const Assembling thing(spec);
    CHECK(thing.body().regions.empty());
    CHECK(thing.raw_findings().size() == 1);
    CHECK_FALSE(thing.raw_findings().HasErrors());
    return thing.findings().at(0);
  };
  const std::string hint =
      " (search with a smaller `area`, `height` or `margin`, or declare it with its `size`)";
  CHECK(finding("parts: [{name: a, type: sphere, size: 1}]\nregions: auto\n") ==
        "4:10 region 'surface' does not exist: no level face that collides" + hint);
  const std::string low =
      "parts:\n"
      "- {name: low, type: box, size: [0.1, 0.1, 0.01]}\n"
      "- {name: high, type: box, size: [0.1, 0.1, 0.01], pos: [0, 0, 0.04], role: collision}\n";
  CHECK(finding(low + "regions: [{name: s, type: auto, area: 0.05}]\n") ==
        "6:11 region 's' does not exist: no level face of at least 0.05 m^2 with 0.03 m of free "
        "height; the largest has 0.04 m^2" +
            hint);
  CHECK(finding(low + "regions: [{name: s, type: auto, margin: 0.1}]\n") ==
        "6:11 region 's' does not exist: its margin of 0.1 m leaves no room on the largest level "
        "face, of 0.04 m^2" +
            hint);
}

TEST_CASE("an empty search of another spec is no warning") {
  TemporaryFolder folder;
  folder.Write(
      "ball.yaml",
      "{mjforge: 1, name: ball, parts: [{name: a, type: sphere, size: 1}], regions: auto}");
  const Assembling thing("bodies: [{name: ball, spec: ball.yaml}]\n", 1, 0, folder.path());
  CHECK(thing.object().bodies.size() == 2);
  CHECK(thing.findings().empty());
}

TEST_CASE("auto joins the pieces of one part, and takes only what collides") {
  const Assembling thing(
      "parts:\n"
      "- {name: dish, type: lathe, facets: 12, wall: 5mm,\n"
      "   profile: [[0, 0], [0.1, 0], [0.15, 0.06]]}\n"
      "- {name: look, type: box, size: [1, 1, 1], role: visual}\n"
      "regions: auto\n");
  REQUIRE(thing.body().regions.size() == 1);
  const model::Region& region = thing.body().regions[0];
  CHECK(region.X_BR.p.isApprox(Eigen::Vector3d(0, 0, 0.005), 1e-6));
  CHECK(region.half_size.x() > 0.085);
  CHECK(region.half_size.x() < 0.11);
}

TEST_CASE("auto sees faces where they are at the start") {
  const Assembling thing(
      "parts: [{name: a, type: sphere, size: [0.1], pos: [0, 0, -1]}]\n"
      "bodies:\n"
      "- name: flap\n"
      "  parts: [{name: b, type: box, size: [0.01, 0.2, 0.3], pos: [0, 0, 0.3]}]\n"
      "  joints: [{name: hinge, axis: [0, 1, 0], range: [0, 90deg]}]\n"
      "  regions: auto\n"
      "pose: {hinge: 90deg}\n");
  const std::vector<model::Region>& regions = thing.object().bodies.at(1).regions;
  REQUIRE(regions.size() == 1);
  CHECK(regions[0].site == "thing_flap_surface");
  CHECK(regions[0].X_BR.p.isApprox(Eigen::Vector3d(-0.01, 0, 0.3)));
}

}  // namespace
}  // namespace mjforge::assemble
