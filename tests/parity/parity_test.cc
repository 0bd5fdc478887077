// Tests that our objects have the parts, joints, sites and masses of robosuite's objects, except
// for the differences listed in differences.cc.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cases.h"
#include "described.h"
#include "differences.h"
#include "our_object.h"
#include "reference_object.h"

namespace mjforge::parity {
namespace {

using nlohmann::json;

// Compares the numbers and words of the reference, which omits invisible properties.
void CompareElements(std::string_view reference, const std::string& name, const Element& theirs,
                     const Element& ours) {
  INFO(name);
  for (const auto& [word, value] : theirs.words) {
    INFO(word);
    CHECK(ours.words.at(word) == value);
  }
  for (const auto& [field, numbers] : theirs.numbers) {
    INFO(field << ": reference " << Catch::Detail::stringify(numbers));
    const Difference* difference = FindDifference(reference, name, field);
    const Numbers& right = difference != nullptr ? difference->right : numbers;
    const auto found = ours.numbers.find(field);
    REQUIRE(found != ours.numbers.end());
    INFO("ours " << Catch::Detail::stringify(found->second));
    CHECK(Close(field, found->second, right));
  }
}

// Returns true if any geom of the part has the difference's field. Visual twins have no contact
// parameters, so a difference can concern only one of the two geoms.
bool SomeGeomHas(const Described& described, const Difference& difference) {
  return std::ranges::any_of(described, [&](const auto& entry) {
    return PartOf(entry.first) == difference.element &&
           entry.second.numbers.contains(std::string(difference.field));
  });
}

std::set<std::string> Names(const Described& described) {
  std::set<std::string> names;
  for (const auto& entry : described) names.insert(entry.first);
  return names;
}

std::set<std::string> ExpectedNames(const Described& theirs, std::string_view object_class,
                                    std::string_view reference) {
  std::set<std::string> names;
  for (const auto& entry : theirs) names.insert(OurName(object_class, entry.first));
  for (const Added& added : AddedElements()) {
    if (added.where == object_class || added.where == reference) names.emplace(added.element);
  }
  return names;
}

std::vector<spec::Setting> PinsOf(const Case& one, const json& reference) {
  return one.pins != nullptr ? one.pins(reference) : std::vector<spec::Setting>{};
}

}  // namespace

TEST_CASE("every object is the reference's to 1e-6") {
  for (const Case& one : Cases()) {
    DYNAMIC_SECTION(one.reference) {
      const json reference = ReadReference(one.reference);
      const auto object_class = reference.at("class").get<std::string>();
      const auto name = reference.at("params").at("name").get<std::string>();
      const Described theirs = DescribeReference(reference);
      const OurObject ours = MakeObject(SpecPath(one), name, PinsOf(one, reference));
      REQUIRE(ours.findings == "");
      REQUIRE(Names(ours.described) == ExpectedNames(theirs, object_class, one.reference));
      for (const auto& [element, numbers] : theirs) {
        CompareElements(one.reference, element, numbers,
                        ours.described.at(OurName(object_class, element)));
      }
    }
  }
}

TEST_CASE("every reference file is compared") {
  std::vector<std::string> known;
  for (const Case& one : Cases()) known.emplace_back(one.reference);
  std::ranges::sort(known);
  CHECK(known == ReferenceNames());
}

TEST_CASE("every named difference is one: the reference has another number there") {
  for (const Difference& difference : Differences()) {
    INFO(difference.reference << " " << difference.element << " " << difference.field);
    const Described theirs = DescribeReference(ReadReference(difference.reference));
    CHECK(SomeGeomHas(theirs, difference));
    CHECK(difference.reason != "");
    for (const auto& [name, element] : theirs) {
      const auto found = element.numbers.find(std::string(difference.field));
      if (PartOf(name) != difference.element || found == element.numbers.end()) continue;
      CHECK_FALSE(Close(difference.field, difference.right, found->second));
    }
  }
}

TEST_CASE("every renamed element is in a reference of its class, no added one is") {
  std::set<std::string> all;
  for (const std::string& name : ReferenceNames()) {
    const json reference = ReadReference(name);
    for (const auto& entry : DescribeReference(reference)) {
      all.insert(reference.at("class").get<std::string>() + " " + PartOf(entry.first));
      all.insert(name + " " + PartOf(entry.first));
    }
  }
  for (const Renamed& renamed : RenamedElements()) {
    CHECK(all.contains(std::string(renamed.object_class) + " " + std::string(renamed.element)));
    CHECK(renamed.reason != "");
  }
  for (const Added& added : AddedElements()) {
    CHECK_FALSE(all.contains(std::string(added.where) + " " + std::string(added.element)));
    CHECK(added.reason != "");
  }
}

// With these numbers robosuite's ring is 0.1 m tall and has a hole of 0.02772 m.
TEST_CASE("a ring has the height and the clear hole it was asked for") {
  const OurObject ring = MakeObject("robosuite/hollow_cylinder", "ring",
                                    {{.name = "outer_radius", .text = "0.0425"},
                                     {.name = "inner_radius", .text = "0.03"},
                                     {.name = "height", .text = "0.05"},
                                     {.name = "ngeoms", .text = "8"}});
  REQUIRE(ring.findings == "");
  // The inner face of the box at +x is at 0.03.
  const Element& box = ring.described.at("geom/hc_4");
  const Numbers& pos = box.numbers.at("pos");
  const Numbers& size = box.numbers.at("size");
  CHECK(Close("pos", {pos[0] - size[0], pos[1]}, {0.03, 0}));
  CHECK(Close("size", {size[2]}, {0.025}));
  const Element& whole = ring.described.at("whole");
  CHECK(Close("aabb_max", {whole.numbers.at("aabb_max")[2]}, {0.025}));
  CHECK(Close("horizontal_radius", whole.numbers.at("horizontal_radius"), {0.0425}));
}

// The reference has no cone, so the expected values follow robosuite's formula: an odd number n of
// discs of height h / n, with radii from the outer to the inner radius in equal steps.
TEST_CASE("a cone is a stack of an odd number of discs, widest at the bottom") {
  const OurObject cone = MakeObject("robosuite/cone", "cone",
                                    {{.name = "outer_radius", .text = "0.0425"},
                                     {.name = "inner_radius", .text = "0.03"},
                                     {.name = "height", .text = "0.05"},
                                     {.name = "ngeoms", .text = "8"},
                                     {.name = "use_box", .text = "false"}});
  REQUIRE(cone.findings == "");
  double mass = 0;
  for (int i = 0; i < 9; ++i) {
    const double radius = 0.0425 - i * 0.0125 / 8;
    const Element& disc = cone.described.at("geom/c_" + std::to_string(i));
    CHECK(Close("size", disc.numbers.at("size"), {radius, 0.05 / 18}));
    CHECK(Close("pos", disc.numbers.at("pos"), {0, 0, (i - 4) * 0.05 / 9}));
    mass += 1000 * std::numbers::pi * radius * radius * 0.05 / 9;
  }
  CHECK_FALSE(cone.described.contains("geom/c_9"));
  CHECK(Close("mass", cone.described.at("whole").numbers.at("mass"), {mass}));
}

TEST_CASE("a cone of a material of the library has that one's density and friction") {
  const OurObject cone =
      MakeObject("robosuite/cone", "cone",
                 {{.name = "use_box", .text = "true"}, {.name = "material", .text = "oak"}});
  REQUIRE(cone.findings == "");
  CHECK(cone.described.at("geom/c_0").numbers.at("density") == Numbers{755});
  CHECK(cone.described.at("geom/c_0").numbers.at("friction")[0] == 0.5);
}

TEST_CASE("a solid handle of a pot is as wide as handle_width and may be as wide as the pot") {
  const OurObject pot = MakeObject("robosuite/pot_with_handles", "pot",
                                   {{.name = "body_half_size", .text = "[0.05, 0.05, 0.05]"},
                                    {.name = "handle_width", .text = "0.1"},
                                    {.name = "solid_handle", .text = "true"}});
  REQUIRE(pot.findings == "");
  CHECK(pot.described.at("geom/handle0").numbers.at("size")[0] == 0.05);
}

TEST_CASE("a mug weighs what its turned clay weighs") {
  const OurObject mug = MakeObject("containers/mug", "mug",
                                   {{.name = "outer_radius", .text = "0.04"},
                                    {.name = "height", .text = "0.1"},
                                    {.name = "wall", .text = "0.004"},
                                    {.name = "bottom", .text = "0.005"},
                                    {.name = "handle_shape", .text = "none"},
                                    {.name = "density", .text = "2400"}});
  REQUIRE(mug.findings == "");
  // The volume is a cylinder minus the hollow, minus the volume cut off by the three straight edges
  // that replace a rounding.
  const double pi = std::numbers::pi;
  const double solid = pi * (0.04 * 0.04 * 0.1 - 0.036 * 0.036 * 0.095);
  double cut = 0;
  for (int i = 0; i < 3; ++i) {
    const auto r = [pi](int k) { return 0.038 + 0.002 * std::sin(pi * k / 6); };
    const auto z = [pi](int k) { return 0.002 - 0.002 * std::cos(pi * k / 6); };
    // The volume between a straight edge and the radius of the mug is an integral of a parabola.
    const double a = r(i);
    const double b = r(i + 1);
    cut += pi * (z(i + 1) - z(i)) * (0.04 * 0.04 - (a * a + a * b + b * b) / 3);
  }
  CHECK(Close("mass", mug.described.at("whole").numbers.at("mass"), {2400 * (solid - cut)}));
  CHECK_FALSE(mug.described.contains("site/grasp"));
}

}  // namespace mjforge::parity
