#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "loading.h"

TEST_CASE("parameters may stand in any order", "[params]") {
  const Loaded loaded = LoadWithBox("params: {c: 2 * b, b: a + 1, a: 1 .. 2}\n");
  REQUIRE(loaded.Report() == Strings{});
  CHECK(loaded.spec->parameters[0].name == "c");
  CHECK(loaded.spec->evaluation_order == std::vector<int>{2, 1, 0});
}

TEST_CASE("a cycle of parameters prints the cycle", "[params]") {
  CHECK(ReportWithBox("params:\n  a: b + 1\n  b: c\n  c: 2 * a\n") ==
        Strings{"5:3 spec/cycle: parameters depend on each other: a -> b -> c -> a"});
  CHECK(ReportWithBox("params: {a: a + 1}\n") ==
        Strings{"4:10 spec/cycle: parameters depend on each other: a -> a"});
}

TEST_CASE("a chain of ten thousand parameters is no problem", "[params]") {
  std::string text = "params:\n  p0: 1\n";
  for (int i = 1; i < 10'000; ++i) {
    text += "  p" + std::to_string(i) + ": p" + std::to_string(i - 1) + " + 1\n";
  }
  CHECK(ReportWithBox(text) == Strings{});
}

TEST_CASE("the long form carries meaning and unit", "[params]") {
  const Loaded loaded = LoadWithBox(
      "params:\n"
      "  r: {value: 1cm .. 2cm, doc: Radius of it, unit: m}\n"
      "  s: {choice: [box, ball], doc: Shape}\n");
  REQUIRE(loaded.Report() == Strings{});
  CHECK(loaded.spec->parameters[0].doc == "Radius of it");
  CHECK(loaded.spec->parameters[0].unit == "m");
  CHECK(loaded.spec->parameters[0].source == "1cm .. 2cm");
  CHECK(loaded.spec->parameters[1].source == "{choice: [box, ball]}");
}

TEST_CASE("a section is a heading for parameters and for all columns of a record", "[params]") {
  const Loaded loaded = LoadWithBox(
      "params:\n"
      "  section: 2cm\n"
      "  r: {value: 1cm .. section, section: Section of the ball}\n"
      "  s: {normal: [3, 1], section: Other}\n"
      "  style: {choice: [{name: old, leg: 1cm}, {name: new, leg: 2cm}], section: Legs}\n"
      "  bare: 1\n");
  REQUIRE(loaded.Report() == Strings{});
  Strings sections;
  for (const auto& parameter : loaded.spec->parameters) sections.push_back(parameter.section);
  CHECK(sections == Strings{"", "Section of the ball", "Other", "Legs", "Legs", ""});
  CHECK(loaded.spec->parameters[1].source == "1cm .. section");
  CHECK(loaded.spec->parameters[2].source == "{normal: [3, 1]}");
}

TEST_CASE("a section that is no heading is reported", "[params]") {
  CHECK(ReportWithBox("params: {r: {value: 1, section: [a, b]}}\n") ==
        Strings{"4:33 spec/wrong-type: expected text for 'section', got a list"});
  CHECK(ReportWithBox("params: {r: {value: 1, section: \"\"}}\n") ==
        Strings{"4:33 spec/bad-value: 'section' is empty (name the heading, as in `section: "
                "Handle`)"});
  CHECK(ReportWithBox("params: {r: {value: 1, section: \"a ${r}\"}}\n") ==
        Strings{"4:33 spec/wrong-type: 'section' is fixed text: ${...} has no meaning in it"});
}

TEST_CASE("a name of the expression language is no parameter's name", "[params]") {
  const Strings report = ReportWithBox("params: {index: 1, max: 2, 2x: 3}\n");
  REQUIRE(report.size() == 3);
  CHECK(report[0] ==
        "4:10 spec/bad-name: 'index' is a word of the expression language; a parameter needs "
        "another name");
  CHECK(report[2] ==
        "4:28 spec/bad-name: parameter name '2x' is not a valid name (a letter, then letters, "
        "digits and underscores)");
}

TEST_CASE("a setting replaces a parameter's value and keeps its meaning", "[params]") {
  const std::string yaml =
      "mjforge: 1\nname: t\nparams: {r: {value: 1 .. 2, doc: Radius}, d: 2 * r}\n"
      "parts: [{name: a, type: sphere, size: r}]\n";
  const Loaded loaded = Load(yaml, {{.name = "r", .text = "5"}});
  REQUIRE(loaded.Report() == Strings{});
  CHECK(std::get<double>(loaded.spec->parameters[0].value.form) == 5);
  CHECK(loaded.spec->parameters[0].doc == "Radius");
  CHECK(loaded.spec->settings == std::vector<std::pair<std::string, std::string>>{{"r", "5"}});
  CHECK(Load(yaml, {{.name = "r", .text = "{normal: [1, 0.1], clip: [0.5, 2]}"}}).Report().empty());
}

TEST_CASE("a setting of an unknown parameter is reported at the setting", "[params]") {
  const std::string yaml =
      "mjforge: 1\nname: t\nparams: {radius: 1, shape: {choice: [box, ball]}}\n"
      "parts: [{name: a, type: sphere, size: radius}]\n";
  const Loaded loaded = Load(yaml, {{.name = "radus", .text = "5"}});
  REQUIRE(
      loaded.Report() ==
      Strings{"1:8 spec/unknown-parameter: 't' has no parameter 'radus' (did you mean 'radius'?)"});
  CHECK(loaded.sources.Name(loaded.findings[0].mark.file) == "--set");
  CHECK(Load(yaml, {{.name = "shape", .text = "bal"}}).Report() ==
        Strings{"1:8 spec/bad-value: 'bal' is not one of box, ball (did you mean 'ball'?)"});
}

TEST_CASE("a text with the name of a parameter among its words can be set", "[params]") {
  const mjforge::harness::TemporaryFolder folder;
  folder.Write("tints.csv", "name,weight\ndeep orange,0\nred,1\n");
  const std::string yaml =
      "mjforge: 1\nname: t\nparams: {deep: 1 .. 2, tint: {rows: " +
      (folder / "tints.csv").string() +
      ", weights: weight}}\nparts: [{name: p, type: sphere, size: deep, if: tint.name != 'red'}]\n";
  for (const char* text : {"deep orange", "red"})
    CHECK(Load(yaml, {{.name = "tint.name", .text = text}}).Report() == Strings{});
  CHECK(Load(yaml, {{.name = "tint.name", .text = "deep blue"}}).Report().size() > 0);
}

TEST_CASE("a choice of digits is set as text, quoted or in an expression", "[params]") {
  const std::string yaml =
      "mjforge: 1\nname: t\nparams: {size: {choice: ['8', '10']}}\n"
      "parts: [{name: \"a_${size}\", type: sphere, size: 1}]\n";
  for (const std::string text : {"'8'", "${'8'}"})
    CHECK(Load(yaml, {{.name = "size", .text = text}}).Report() == Strings{});
  CHECK(Load(yaml, {{.name = "size", .text = "'9'"}}).Report() ==
        Strings{"1:7 spec/bad-value: '9' is not one of 8, 10"});
  const std::string one =
      "mjforge: 1\nname: t\nparams: {size: '8'}\n"
      "parts: [{name: \"a_${size}\", type: sphere, size: 1}]\n";
  CHECK(Load(one, {{.name = "size", .text = "9"}}).Report() ==
        Strings{"1:7 spec/wrong-type: parameter 'size' is text, but '9' is a number (the spec has "
                "'size: '8'')"});
}

TEST_CASE("a setting of another kind is one finding, at the setting", "[params]") {
  const std::string yaml =
      "mjforge: 1\nname: t\nparams: {length: 1cm .. 2cm, half: [1, 2, 3], flag: true, d: 2 * "
      "length}\n"
      "parts:\n- {name: a, type: sphere, size: length}\n- {name: b, type: box, size: half}\n"
      "- {name: c, type: sphere, size: d, if: flag, pos: [half.x + length, 0, 0]}\n";
  const auto report = [&yaml](const std::string& name, const std::string& text) {
    return Load(yaml, {{.name = name, .text = text}}).Report();
  };
  CHECK(report("length", "abc") ==
        Strings{"1:9 spec/wrong-type: parameter 'length' is a number, but 'abc' is text (the spec "
                "has 'length: 1cm .. 2cm')"});
  CHECK(report("length", "[1, 2]") ==
        Strings{"1:9 spec/wrong-type: parameter 'length' is a number, but '[1, 2]' is 2 numbers "
                "(the spec has 'length: 1cm .. 2cm')"});
  CHECK(report("half", "3") ==
        Strings{"1:7 spec/wrong-type: parameter 'half' is 3 numbers, but '3' is a number (the spec "
                "has 'half: [1, 2, 3]')"});
  CHECK(report("flag", "1").size() == 1);
  CHECK(report("half", "[1, abc, 3]").size() == 1);
  CHECK(report("length", "2 * d").size() == 1);  // a cycle
  CHECK(report("length", "half.y") == Strings{});
}

TEST_CASE("a setting in another unit, or in a circle, is reported at the setting", "[params]") {
  const std::string yaml =
      "mjforge: 1\nname: t\nparams: {length: {value: 1cm, unit: m}, ratio: 2, d: 2 * length}\n"
      "parts: [{name: a, type: sphere, size: d * ratio}]\n";
  const auto report = [&yaml](const std::string& text) {
    const Loaded loaded = Load(yaml, {{.name = "length", .text = text}});
    for (const auto& finding : loaded.findings)
      CHECK(loaded.sources.Name(finding.mark.file) == "--set");
    return loaded.Report();
  };
  CHECK(report("{value: 2, unit: m}") == Strings{});
  CHECK(report("{value: 2, unit: rad}") ==
        Strings{"1:26 expr/units: parameter 'length' is in m, but this is in rad"});
  CHECK(report("{value: 2kg, unit: kg}").size() == 1);
  CHECK(report("{value: 2, unit: mm}") ==
        Strings{"1:26 spec/bad-value: 'mm' is not a unit of parameters, whose values are in m "
                "(write `unit: m`, and 15mm for 15 mm)"});
  CHECK(report("d / 2") ==
        Strings{"1:9 spec/cycle: parameters depend on each other: length -> d -> length"});
}

TEST_CASE("a list of one number is a number", "[params]") {
  const std::string yaml =
      "mjforge: 1\nname: t\nparams: {r: [1 .. 2]}\n"
      "parts: [{name: a, type: sphere, size: r}, {name: b, type: sphere, size: [2 * r]}]\n";
  CHECK(Load(yaml).Report() == Strings{});
  const Loaded loaded = Load(yaml, {{.name = "r", .text = "[0.05]"}});
  REQUIRE(loaded.Report() == Strings{});
  CHECK(std::get<double>(loaded.spec->parameters[0].value.form) == 0.05);
}

TEST_CASE("a requirement is a condition", "[params]") {
  CHECK(ReportWithBox("params: {r: 1}\nrequire: [r > 0, r < 2]\n") == Strings{});
  CHECK(ReportWithBox("params: {r: 1}\nrequire: r + 1\n") ==
        Strings{
            "5:10 spec/wrong-type: expected a condition, but 'r + 1' is a number (compare it with "
            "something, as in `x > 0`)"});
}
