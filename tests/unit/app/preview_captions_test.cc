#include "preview_captions.h"

#include <catch2/catch.hpp>

#include "mjforge/forge/forge.h"

namespace mjforge::app {
namespace {

using Lines = std::vector<std::string>;

// A spec with parameters as `source` says, and two variants of it.
struct Family {
  void Add(std::string name, std::string source, std::string unit, sample::ParameterValue first,
           sample::ParameterValue second) {
    spec::Parameter parameter;
    parameter.name = name;
    parameter.source = std::move(source);
    parameter.unit = std::move(unit);
    parameter.value.form = spec::Draw();
    spec.parameters.push_back(std::move(parameter));
    records[0].params.emplace_back(name, std::move(first));
    records[1].params.emplace_back(name, std::move(second));
  }
  std::vector<Lines> Captions(int width = 320) {
    records[1].index = 1;
    return app::MakeCaptions(records, spec, width);
  }

  spec::ObjectSpec spec;
  std::vector<manifest::Record> records{2};
};

TEST_CASE("captions name what is seen to differ: words, then sizes, with units") {
  Family family;
  family.Add("friction", "0.1 .. 1", "1", 0.1, 0.9);
  family.Add("stiffness", "0 .. 9", "Nm/rad", 0.0, 9.0);
  family.Add("radius", "8mm .. 9mm", "m", 0.0081, 0.0089);
  family.Add("height", "0.2 .. 1.3", "m", 0.2812, 1.25);
  family.Add("style", "{choice: [round, square]}", "", std::string("round"), std::string("square"));
  CHECK(family.Captions() == std::vector<Lines>{{"#0", "round, height 28 cm, radius 8.1 mm"},
                                                {"#1", "square, height 1.2 m, radius 8.9 mm"}});
  CHECK(family.Captions(200) ==
        std::vector<Lines>{{"#0", "round, height 28 cm", "radius 8.1 mm"},
                           {"#1", "square, height 1.2 m", "radius 8.9 mm"}});
}

TEST_CASE("a caption reads as a sentence would: choices and counts before their nouns") {
  Family family;
  family.Add("tall", "1 .. 2", "m", 1.0, 2.0);
  family.Add("spokes", "{integer: [3, 7]}", "1", 3.0, 7.0);
  family.Add("has_lid", "{chance: 0.5}", "", true, false);
  family.Add("metal", "{choice: [cast_iron, brass]}", "", std::string("cast_iron"),
             std::string("brass"));
  family.Add("handle_look", "{choice: [a]}", "", std::string("second_glaze"), std::string("none"));
  CHECK(family.Captions() ==
        std::vector<Lines>{{"#0", "lid, cast iron, second glaze handle", "3 spokes"},
                           {"#1", "no lid, brass, no handle, 7 spokes"}});
}

TEST_CASE("a row of a table is known by its name alone") {
  Family family;
  family.Add("size.name", "{choice: [...]}", "", std::string("M5"), std::string("M8"));
  family.Add("length", "4cm .. 8cm", "m", 0.04, 0.08);
  CHECK(family.Captions() ==
        std::vector<Lines>{{"#0", "M5, length 4 cm"}, {"#1", "M8, length 8 cm"}});
}

TEST_CASE("a unit that a spec does not name is seen in its values") {
  Family family;
  family.Add("gap", "0.5mm .. 2mm", "", 0.001, 0.002);
  family.Add("turn", "30deg .. 45deg", "", 0.5235987755982988, 0.7853981633974483);
  family.Add("ratio", "0.5 .. 1", "", 0.5, 0.75);
  CHECK(family.Captions() == std::vector<Lines>{{"#0", "gap 1 mm, turn 30 deg, ratio 0.5"},
                                                {"#1", "gap 2 mm, turn 45 deg, ratio 0.75"}});
}

TEST_CASE("captions leave out what is the same, and lists") {
  Family family;
  family.Add("height", "1cm .. 2cm", "m", 0.01, 0.01);
  family.Add("size", "[1, 2] .. [2, 3]", "m", std::vector<double>{1, 2}, std::vector<double>{2, 2});
  CHECK(family.Captions() == std::vector<Lines>{{"#0"}, {"#1"}});
}

}  // namespace
}  // namespace mjforge::app
