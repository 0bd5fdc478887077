// Tests of the articulated specs of the catalogue: their elements, and that their joints move
// without collisions between bodies.

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "described.h"
#include "harness/effort.h"
#include "harness/source_folder.h"
#include "mjforge/assemble/assemble.h"
#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"
#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"
#include "mjforge/validate/validate.h"
#include "our_object.h"

namespace mjforge::parity {
namespace {

constexpr double kPi = std::numbers::pi;

// Returns the pairs of geoms that meet while the joints move, in any of 20 variants: "strike
// tongue".
std::set<std::string> Meetings(const std::string& name,
                               const std::vector<spec::Setting>& settings) {
  std::set<std::string> meetings;
  diag::Sources sources;
  diag::Findings findings;
  const auto spec = spec::LoadSpec(name,
                                   {.settings = settings,
                                    .parameter_files = {},
                                    .search_path = {harness::SourceFolder() / "specs"}},
                                   sources, findings);
  REQUIRE(spec != nullptr);
  assemble::Assembler assembler;
  validate::Loader loader;
  mjcf::MjcfDocument document;
  const auto count = static_cast<std::uint64_t>(harness::Effort(20));
  for (std::uint64_t index = 0; index < count; ++index) {
    INFO("variant " << index);
    auto values =
        sample::Sample(*spec, {.seed = 3, .index = index}, sample::kRootStream, {}, findings);
    REQUIRE(values);
    const auto object = assembler.Assemble(*values, {}, findings);
    REQUIRE(object);
    mjcf::WriteMjcf(*object, mjcf::Target::kMujoco, {}, document);
    const auto sweep = loader.SweepJoints(document, *object, findings);
    REQUIRE(sweep);
    for (const validate::Sweep::Contact& contact : sweep->contacts) {
      meetings.insert(WithoutPrefix(contact.geom1, object->name + "_") + " " +
                      WithoutPrefix(contact.geom2, object->name + "_"));
    }
  }
  CHECK(findings.empty());
  return meetings;
}

}  // namespace

TEST_CASE("the joints of articulated specs move without a contact") {
  for (const std::string name :
       {"articulated/drawer_cabinet", "articulated/faucet", "articulated/jar_with_lid",
        "articulated/scissors", "robosuite/hinged_box", "robosuite/ratcheting_wrench"}) {
    DYNAMIC_SECTION(name) { CHECK(Meetings(name, {}) == std::set<std::string>{}); }
  }
}

TEST_CASE("a door moves freely but for its latch") {
  CHECK(Meetings("articulated/door_with_lever", {{.name = "latch", .text = "false"}}) ==
        std::set<std::string>{});
  for (const std::string& meeting : Meetings("articulated/door_with_lever", {})) {
    CHECK(meeting == "strike tongue");
  }
}

// The reference has no wrench, so the expected values follow robosuite's formulas. The inner radius
// of its rings is a; the inner radius of ours is that of the clear hole, a * cos(pi / n).
TEST_CASE("the rings of a ratcheting wrench take the ends of its handle into their walls") {
  const double R = 0.0425;
  const double a = 0.03;
  const double c = std::cos(kPi / 8);
  const auto hole = std::to_string(a) + " * cos(pi / 8)";
  const OurObject wrench = MakeObject("robosuite/ratcheting_wrench", "wrench",
                                      {{.name = "handle_size", .text = "[0.08, 0.01, 0.005]"},
                                       {.name = "outer_radius_1", .text = "0.0425"},
                                       {.name = "outer_radius_2", .text = "0.0425"},
                                       {.name = "inner_radius_1", .text = hole},
                                       {.name = "inner_radius_2", .text = hole},
                                       {.name = "height_1", .text = "0.1"},
                                       {.name = "height_2", .text = "0.05"},
                                       {.name = "ngeoms", .text = "8"},
                                       {.name = "grip", .text = "true"},
                                       {.name = "grip_size", .text = "[0.015, 0.04]"},
                                       {.name = "density", .text = "1000"},
                                       {.name = "grip_density", .text = "1000"}});
  REQUIRE(wrench.findings == "");
  const Described& described = wrench.described;
  const double x = 0.08 + R - (R - a) * c;
  CHECK(Close("pos", described.at("body/hole1").numbers.at("pos"), {-x, 0, 0}));
  CHECK(Close("pos", described.at("body/hole2").numbers.at("pos"), {x, 0, 0}));
  CHECK(Close("quat", described.at("body/grip").numbers.at("quat"),
              {std::sqrt(0.5), 0, std::sqrt(0.5), 0}));

  // The boxes of a ring reach from a c to R c and are as wide as the outer edge.
  const Numbers box = {(R - a) * c / 2, R * std::sin(kPi / 8), 0.05};
  CHECK(Close("size", described.at("geom/hole1_hc_3").numbers.at("size"), box));
  CHECK(Close("size", described.at("geom/handle_g0").numbers.at("size"), {0.08, 0.01, 0.005}));
  CHECK(Close("size", described.at("geom/grip_g0").numbers.at("size"), {0.015, 0.015, 0.04}));
  const double ring = 8 * 8 * box[0] * box[1] * box[2];
  const double rest = 8 * (0.08 * 0.01 * 0.005 + 0.015 * 0.015 * 0.04);
  CHECK(Close("mass", described.at("body/hole1").numbers.at("mass"), {1000 * ring}));
  CHECK(Close("mass", described.at("whole").numbers.at("mass"), {1000 * (1.5 * ring + rest)}));
  CHECK(Close("damping", described.at("joint/joint0").numbers.at("damping"), {0.0005}));
}

TEST_CASE("the lid of a hinged box may be wider than the box") {
  const OurObject box = MakeObject("robosuite/hinged_box", "hinged_box",
                                   {{.name = "box1_size", .text = "[0.03, 0.03, 0.02]"},
                                    {.name = "box2_size", .text = "[0.05, 0.04, 0.01]"},
                                    {.name = "gap", .text = "0.3mm"}});
  REQUIRE(box.findings == "");
  CHECK(Close("pos", box.described.at("body/box2").numbers.at("pos"), {-0.02, 0, 0.0303}));
}

TEST_CASE("the slides of a cabinet are its drawers', as many as asked for") {
  const OurObject cabinet =
      MakeObject("articulated/drawer_cabinet", "cabinet",
                 {{.name = "drawers", .text = "4"}, {.name = "travel_ratio", .text = "0.5"}});
  REQUIRE(cabinet.findings == "");
  const Described& described = cabinet.described;
  for (const char* number : {"0", "1", "2", "3"}) {
    const Element& slide = described.at(std::string("joint/slide_") + number);
    CHECK(slide.words.at("body") == std::string("drawer_") + number);
    CHECK(slide.words.at("type") == "slide");
    CHECK(slide.numbers.at("axis") == Numbers{0, -1, 0});
    // The range is half the length of the drawer's bottom.
    const Element& bottom = described.at(std::string("geom/bottom_") + number);
    CHECK(Close("range", slide.numbers.at("range"), {0, bottom.numbers.at("size")[1]}));
  }
  CHECK_FALSE(described.contains("joint/slide_4"));
  CHECK_FALSE(described.contains("joint/joint0"));
}

}  // namespace mjforge::parity
