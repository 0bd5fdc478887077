// Peg-in-hole tests: which pegs and bodies fit into which holes.
#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;
using Fitting = Result::Fitting;

// Boards of 20 mm around a square shaft, 10 mm wide and open at both ends, whose mouth is at z = 0.
constexpr const char* kShaft =
    R"(<geom name="left" type="box" size="0.01 0.02 0.01" pos="-0.015 0 -0.01"/>
  <geom name="right" type="box" size="0.01 0.02 0.01" pos="0.015 0 -0.01"/>
  <geom name="front" type="box" size="0.005 0.01 0.01" pos="0 -0.015 -0.01"/>
  <geom name="back" type="box" size="0.005 0.01 0.01" pos="0 0.015 -0.01"/>)";
constexpr const char* kInto = R"(<site name="mouth" zaxis="0 0 -1"/>)";

model::Checks Fits(double width, double depth) {
  model::Checks checks;
  model::FittingCheck& fits = checks.fits.emplace_back();
  fits.hole = "mouth";
  fits.peg = {width, width};
  fits.depth = depth;
  checks.silenced = {{"physics/overlap", "the boards meet in the corners"}};
  return checks;
}

std::string MessageOf(const Examined& examined) {
  return examined.findings.begin() == examined.findings.end() ? std::string()
                                                              : examined.findings.begin()->message;
}

TEST_CASE("a peg that is narrower than its hole goes in, and a wider one does not") {
  const std::string world = Free(0, std::string(kShaft) + kInto);
  const Examined narrow = Examine(world, {}, Fits(0.0095, 0.02));
  CHECK(narrow.Codes().empty());
  CHECK(narrow.result->fits == Fitting{1, 1});
  const Examined wide = Examine(world, {}, Fits(0.012, 0.02));
  CHECK(wide.Codes() == Strings{"error physics/does-not-fit"});
  CHECK(wide.result->fits == Fitting{1, 0});
  CHECK_THAT(MessageOf(wide), Catch::Contains("mm into 'mouth', not 20 mm: it touches '"));
}

TEST_CASE("a hole that is too narrow, one that is too shallow, and none at all differ") {
  const auto text = [](const std::string& geoms, double width, double depth) {
    const Examined examined = Examine(Free(0, geoms + kInto), {}, Fits(width, depth));
    REQUIRE(examined.findings.size() == 1);
    return examined.findings[0].message + " (" + examined.findings[0].hint + ")";
  };
  const std::string bottom =
      R"(<geom name="bottom" type="box" size="0.02 0.02 0.002" pos="0 0 -0.022"/>)";
  const std::string site =
      "the site must be at the mouth of a hole that nothing closes, and its z axis is the way in)";
  // The depth at which a contact stops the peg depends on MuJoCo's release.
  const auto goes = [](const char* depth_in_22, const char* depth_in_40, const char* otherwise) {
    return std::string("a peg goes ") + (engine::kHasFixedBuffers ? depth_in_22 : depth_in_40) +
           " mm into 'mouth', not " + otherwise;
  };
  CHECK(text(kShaft, 0.012, 0.02) ==
        goes("0.426", "0.378",
             "20 mm: it touches 'back' "
             "(the hole is deep enough, but too narrow: make it wider, or the peg thinner)"));
  CHECK(text(kShaft + bottom, 0.0095, 0.03) ==
        goes("27.3", "24.1",
             "30 mm: it touches 'bottom' (the hole ends after 20 mm: make it deeper)"));
  CHECK(text(kShaft + bottom, 0.012, 0.03) ==
        goes("0.433", "0.379",
             "30 mm: it touches 'back' (the hole ends after 20 mm: make it wider and deeper)"));
  CHECK(text(R"(<geom name="lid" type="box" size="0.02 0.02 0.01" pos="0 0 -0.01"/>)", 0.005,
             0.01) == "there is no hole at 'mouth': 'lid' is 0 mm behind it (" + site);
  CHECK(text(R"(<geom name="block" type="box" size="0.02 0.02 0.02"/>)", 0.005, 0.01) ==
        "there is no hole at 'mouth': 'block' is 0 mm behind it (" + site);
}

TEST_CASE("a peg fits only where something holds it sideways") {
  const auto check = [](const std::string& site) {
    INFO(site);
    const Examined open = Examine(Free(0, kShaft + site), {}, Fits(0.0095, 0.02));
    CHECK(open.Codes() == Strings{"error physics/does-not-fit"});
    CHECK(open.result->fits == Fitting{1, 0});
    CHECK(MessageOf(open) == "nothing holds a peg sideways, 20 mm behind 'mouth'");
  };
  check(R"(<site name="mouth" zaxis="0 0 1"/>)");                       // out of the hole
  check(R"(<site name="mouth" pos="0.1 0 0" zaxis="0 0 -1"/>)");        // far from it
  check(R"(<site name="mouth" pos="0.031 0 0.015" zaxis="0 0 -1"/>)");  // along its outside
}

TEST_CASE("a file's defaults for joints are not those of a peg") {
  const std::string defaults = R"(<default><joint damping="10" armature="10"/></default>)";
  const Examined damped =
      Examine(Free(0, std::string(kShaft) + kInto), defaults, Fits(0.0095, 0.02));
  CHECK(damped.result->fits == Fitting{1, 1});
}

TEST_CASE("a slot holds a peg, too") {
  const std::string slot = R"(<geom type="box" size="0.01 0.05 0.01" pos="-0.015 0 -0.01"/>
    <geom type="box" size="0.01 0.05 0.01" pos="0.015 0 -0.01"/>
    <geom type="box" size="0.005 0.01 0.01" pos="0 -0.04 -0.01"/>)";
  const Examined held = Examine(Free(0, slot + kInto), {}, Fits(0.0095, 0.02));
  CHECK(held.Codes().empty());
  CHECK(held.result->fits == Fitting{1, 1});
}

TEST_CASE("a peg that is much narrower than its hole is not held by it") {
  const Examined loose = Examine(Free(0, std::string(kShaft) + kInto), {}, Fits(0.002, 0.02));
  CHECK(loose.Codes() == Strings{"error physics/does-not-fit"});
}

TEST_CASE("what fits around something is held by it") {
  // Four walls that go over a post.
  const std::string cap = R"(<body name="cap" pos="0.2 0 0"><freejoint/>
    <geom type="box" size="0.002 0.01 0.01" pos="0.008 0 0"/>
    <geom type="box" size="0.002 0.01 0.01" pos="-0.008 0 0"/>
    <geom type="box" size="0.006 0.002 0.01" pos="0 0.008 0"/>
    <geom type="box" size="0.006 0.002 0.01" pos="0 -0.008 0"/>
    <site name="rim" pos="0 0 -0.01" zaxis="0 0 -1"/></body>)";
  model::Checks checks = Fits(0, 0.01);
  checks.fits[0].body = "cap";
  checks.fits[0].tip = "rim";
  const auto with_post = [](double half) {
    return Free(0, R"(<geom type="box" size="0.03 0.03 0.01" pos="0 0 -0.03"/>
      <geom type="box" size=")" +
                       std::to_string(half) + " " + std::to_string(half) +
                       R"( 0.01" pos="0 0 -0.01"/>)" + kInto);
  };
  const Examined held = Examine(with_post(0.0055) + cap, {}, checks);
  CHECK(held.Codes().empty());
  CHECK(held.result->fits == Fitting{1, 1});
  CHECK(Examine(with_post(0.0065) + cap, {}, checks).result->fits == Fitting{1, 0});
}

}  // namespace
}  // namespace mjforge::physics
