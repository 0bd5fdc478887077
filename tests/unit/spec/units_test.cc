// Units: what a value is in, and what its key wants.

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "harness/temporary_folder.h"
#include "loading.h"

namespace mjforge::spec {
namespace {

using Cases = std::vector<std::pair<std::string, std::string>>;

// The one finding's place and message; each finding has the code of units.
std::string OnlyFinding(const Loaded& loaded) {
  const Strings report = loaded.Report();
  if (report.empty()) return "";
  constexpr std::string_view kCode = " expr/units: ";
  const std::size_t code = report.front().find(kCode);
  if (report.size() != 1 || code == std::string::npos) {
    std::string all;
    for (const std::string& line : report) all += line + "\n";
    return all;
  }
  return report.front().substr(code + kCode.size());
}

std::string OfParameters(const std::string& params, std::vector<Setting> settings = {}) {
  return OnlyFinding(Load(
      "mjforge: 1\nname: t\nparams: " + params + "\nparts: [{name: a, type: sphere, size: 1}]\n",
      std::move(settings)));
}

std::string OfPart(const std::string& keys) {
  return OnlyFinding(
      Load("mjforge: 1\nname: t\n"
           "params: {w: 1cm .. 2cm, load: {value: 1 .. 2, unit: kg}, plain: 3, "
           "offset: [1cm, 2cm, 3cm], weights: {each: 1g .. 2g, count: 5}}\n"
           "parts: [{name: a, " +
           keys + "}]\n"));
}

std::string OfJoint(const std::string& keys) {
  return OnlyFinding(
      Load("mjforge: 1\nname: t\nbodies: [{name: b, parts: [{name: a, type: sphere, "
           "size: 1}], joints: [{name: j, " +
           keys + "}]}]\n"));
}

TEST_CASE("a key takes numbers in its own unit, and plain ones") {
  for (const char* keys :
       {"type: sphere, size: w", "type: sphere, size: 3", "type: sphere, size: plain * w",
        "type: box, size: offset", "type: box, size: [w, 2, offset.z]",
        "type: sphere, size: 1, friction: [1, 5mm, 0.1mm], solref: [20ms, 1]",
        "type: sphere, size: 1, mass: load, user: [3kg, 2m]",
        "type: sphere, size: 1, density: load / w ^ 3, quat: random",
        "type: box, fromto: [0, 0, 0, w, w, 1], size: [1, w]",
        "type: box, fromto: [0, 0, 0, w, w, 1], size: [1, w], up: [0, w, 3]",
        "type: sphere, size: 1, zaxis: [w, 0, 2 * w]", "type: sphere, size: 1, zaxis: offset",
        "type: sphere, size: 1, zaxis: {choice: [[load, 0, 2kg], [w, 1, 0]]}",
        "type: sphere, size: 1, xyaxes: [w, 0, 0, 0, load, 0]",
        "type: sphere, size: 1, axisangle: [w, 0, 0, 90deg]",
        "type: sphere, size: 1, quat: {about: offset}",
        "type: prism, polygon: [[0, 0], [w, 0], [0, 1]], height: w, scale: 2",
        "type: prism, polygon: [[0, 0], [1, 0], [0, 1]], height: w, scale: w"}) {
    CAPTURE(keys);
    CHECK(OfPart(keys).empty());
  }
  for (const auto& [keys, message] : Cases{
           {"type: sphere, size: 3kg", "size is in m, but this is in kg"},
           {"type: sphere, size: load", "size is in m, but this is in kg"},
           {"type: sphere, size: 2 * load", "size is in m, but this is in kg"},
           {"type: sphere, size: w * w", "size is in m, but this is in m^2"},
           {"type: sphere, size: 1kg .. 2kg", "size is in m, but this is in kg"},
           {"type: sphere, size: {normal: [1kg, 1g]}", "size is in m, but this is in kg"},
           {"type: sphere, size: {choice: [w, 2, load]}", "size is in m, but this is in kg"},
           {"type: sphere, size: 'weights[2]'", "size is in m, but this is in kg"},
           {"type: box, size: [w, load, 1]", "size is in m, but this is in kg"},
           {"type: sphere, size: 1, pos: {on_sphere: 3s}", "pos is in m, but this is in s"},
           {"type: sphere, size: 1, mass: 30cm", "mass is in kg, but this is in m"},
           {"type: sphere, size: 1, density: 3kg", "density is in kg/m^3, but this is in kg"},
           {"type: sphere, size: 1, friction: [1, 3kg]", "friction is in m, but this is in kg"},
           {"type: sphere, size: 1, friction: 3kg",
            "friction is a plain number, but this is in kg"},
           {"type: sphere, size: 1, rgba: [1, 1cm, 0, 1]",
            "rgba is a plain number, but this is in m"},
           {"type: sphere, size: 1, rgba: offset",
            "4:48 spec/wrong-length: expected 4 numbers, got 3\n"
            "4:48 expr/units: rgba is a plain number, but this is in m\n"},
           {"type: sphere, size: 1, condim: 3m", "condim is a plain number, but this is in m"},
           {"type: sphere, size: 1, euler: [0, 90deg, 1m]", "euler is in rad, but this is in m"},
           {"type: sphere, size: 1, axisangle: [0, 0, 1, 1m]",
            "axisangle is in rad, but this is in m"},
           {"type: sphere, size: 1, zaxis: [w, 0, 1kg]",
            "zaxis must be in one unit, but is in m and in kg"},
           {"type: sphere, size: 1, xyaxes: [1, 0, w, w, load, 0]",
            "xyaxes must be in one unit, but is in m and in kg"},
           {"type: sphere, size: 1, axisangle: [w, 1s, 0, 1]",
            "axisangle must be in one unit, but is in m and in s"},
           {"type: prism, polygon: [[0, 0], [w, 0], [0, 1kg]], height: w",
            "polygon is in m, but this is in kg"},
           {"type: prism, polygon: [[0, 0], [1, 0], [0, 1]], height: w, scale: 1kg",
            "scale is in m or a plain number, but this is in kg"},
           {"type: sphere, size: w + load",
            "'w' is in m, but 'load' is in kg (both sides of '+' "
            "must be in one unit)"},
       }) {
    CAPTURE(keys);
    CHECK(OfPart(keys) == message);
  }
}

TEST_CASE("a joint's keys are in rad or m, as it turns or slides") {
  CHECK(OfJoint("range: [0, 90deg], damping: 0.1Nm * 1s / 1rad, frictionloss: 1Nm").empty());
  CHECK(OfJoint("type: slide, range: [0, 9cm], damping: 2N * 1s / 1m, armature: 1kg").empty());
  CHECK(OfJoint("axis: [0, 1cm, 2cm]").empty());
  CHECK(OfJoint("axis: [0, 1cm, 2s]") == "axis must be in one unit, but is in m and in s");
  CHECK(OfJoint("range: [0, 5N]") == "range is in rad, but this is in N");
  CHECK(OfJoint("range: [0, 5cm]") == "range is in rad, but this is in m");
  CHECK(OfJoint("type: slide, range: [0, 45deg]") == "range is in m, but this is in rad");
  CHECK(OfJoint("type: slide, stiffness: 3Nm") == "stiffness is in N/m, but this is in Nm");
  CHECK(OfJoint("type: slide, solimplimit: [0.9, 0.95, 1rad]") ==
        "solimplimit is in m, but this is in rad");
  const std::string slides =
      "mjforge: 1\nname: t\ndefaults: {joint: {type: slide}}\nbodies: [{name: b, parts: [{name: a, "
      "type: sphere, size: 1}], joints: [{name: j, range: [0, 1]}]}]\n";
  CHECK(OnlyFinding(Load(slides + "pose: {j: 3kg}\n")) ==
        "a position is in rad or m, but this is in kg");
  CHECK(OnlyFinding(Load(slides + "pose: {j: 3cm}\nchecks: {tilt: 3cm}\n")) ==
        "tilt is in rad, but this is in m");
}

TEST_CASE("the values of a parameter are in one unit") {
  for (const auto& [params, message] : Cases{
           {"{a: 3cm .. 5}", ""},
           {"{a: {choice: [3cm, 5, 2mm]}}", ""},
           {"{a: {beta: [2, 3], range: [1cm, 2cm]}, b: a + 3m}", ""},
           {"{a: {exponential: 3, clip: [1cm, 2cm]}, b: a + 3m}", ""},
           {"{a: [3cm, 90deg]}", ""},
           {"{a: 3cm .. 2kg}", "the ends of a range must be in one unit, but are in m and in kg"},
           {"{a: {choice: [3cm, 2kg]}}",
            "the values to choose from must be in one unit, but are in m and in kg"},
           {"{a: {choice: [[1cm, 2kg], [1cm, 2s]]}}",
            "the values to choose from must be in one unit, but are in m, kg and in m, s"},
           {"{a: {choice: [{leg: 3cm}, {leg: 2kg}]}}",
            "the values to choose from must be in one unit, but are in m and in kg"},
           {"{a: {normal: [5cm, 1kg]}}",
            "the numbers of 'normal' must be in one unit, but are in m and in kg"},
           {"{a: {normal: [5cm, 1cm], clip: [0, 1kg]}}",
            "what is drawn is in m, but this is in kg"},
           {"{a: {beta: [2, 3s]}}", "what 'beta' takes is a plain number, but this is in s"},
           {"{a: {integer: [1, 3m]}}", "what 'integer' takes is a plain number, but this is in m"},
           {"{a: {choice: [1, 2], weights: [1, 3cm]}}",
            "a weight is a plain number, but this is in m"},
           {"{a: [1cm, 2cm, 3kg, 4cm, 5cm]}",
            "the values of a list must be in one unit, but are in m and in kg"},
           {"{a: {each: 1cm .. 2cm, count: 3s}}", "count is a plain number, but this is in s"},
           {"{a: {each: 1cm .. 2cm, count: 3}, b: 'a[1] + 1kg'}",
            "'a[1]' is in m, but '1kg' is in kg (both sides of '+' must be in one unit)"},
           {"{a: {shuffle: [1cm, 2cm, 3cm]}, b: sum(a) + 1kg}",
            "'sum(a)' is in m, but '1kg' is in kg (both sides of '+' must be in one unit)"},
       }) {
    CAPTURE(params);
    CHECK(OfParameters(params) == message);
  }
}

TEST_CASE("a parameter's unit is what its value is in") {
  CHECK(OfParameters("{a: {value: 3, unit: kg}, b: a + 3g}").empty());
  CHECK(OfParameters("{a: {value: 3, unit: books}, b: a + 3g}").empty());
  CHECK(OfParameters("{a: {value: 3, unit: kg}, b: a + 3m}") ==
        "'a' is in kg, but '3m' is in m (both sides of '+' must be in one unit)");
  CHECK(OfParameters("{a: {value: 3kg, unit: m}}") == "parameter 'a' is in m, but this is in kg");
  CHECK(OfParameters("{a: {value: 3kg, unit: '1'}}") ==
        "parameter 'a' is a plain number, but this is in kg");
  CHECK(OfParameters("{a: {value: [20ms, 1cm], unit: 's, 1'}}") ==
        "parameter 'a' is in s, 1, but this is in s, m");
  // A ratio is known to be one, so that its products have units.
  CHECK(OfParameters("{r: {value: 0.9, unit: '1'}, a: r * 3cm + 2kg}") ==
        "'r * 3cm' is in m, but '2kg' is in kg (both sides of '+' must be in one unit)");
  CHECK(OfParameters("{r: 0.9, a: r * 3cm + 2kg}").empty());
  CHECK(Load("mjforge: 1\nname: t\nparams: {a: {value: 3, unit: mm}}\n"
             "parts: [{name: a, type: sphere, size: 1}]\n")
            .Report() == Strings{"3:30 spec/bad-value: 'mm' is not a unit of parameters, whose "
                                 "values are in m (write `unit: m`, and 15mm for 15 mm)"});
  const auto shown = Load(
      "mjforge: 1\nname: t\nparams: {a: 3cm .. 5cm, b: {value: 3, unit: books}, c: 3, d: 2 * a * "
      "a, "
      "e: a / d, f: [20ms, 3], g: {integer: [1, 2]}}\nparts: [{name: a, type: sphere, size: 1}]\n");
  std::string units;
  for (const Parameter& parameter : shown.spec->parameters) units += parameter.unit + ";";
  CHECK(units == "m;books;;m^2;1/m;s, 1;;");
}

TEST_CASE("what is set is in the unit of the parameter") {
  CHECK(OfParameters("{a: 3cm .. 5cm}", {{"a", "7"}}).empty());
  CHECK(OfParameters("{a: 3 .. 5}", {{"a", "7kg"}}).empty());
  CHECK(OfParameters("{a: 3cm .. 5cm}", {{"a", "7kg"}}) ==
        "parameter 'a' is in m, but this is in kg");
  CHECK(OfParameters("{a: {integer: [1, 3]}}", {{"a", "7kg"}}) ==
        "parameter 'a' is a plain number, but this is in kg");
  CHECK(OfParameters("{style: {choice: [{name: x, leg: 3cm}, {name: y, leg: 4cm}]}}",
                     {{"style.leg", "7kg"}}) == "parameter 'style.leg' is in m, but this is in kg");
  const harness::TemporaryFolder folder;
  folder.Write("inner.yaml",
               "mjforge: 1\nname: inner\nparams: {r: 1cm .. 2cm}\n"
               "parts: [{name: a, type: sphere, size: r}]\n");
  const std::string inner = (folder / "inner.yaml").string();
  CHECK(OnlyFinding(Load("mjforge: 1\nname: t\nparts: [{name: a, spec: " + inner +
                         ", params: {r: 3kg}}]\n")) ==
        "parameter 'r' of 'inner' is in m, but this is in kg");
  CHECK(OnlyFinding(Load("mjforge: 1\nname: t\nbodies: [{name: a, spec: " + inner +
                         "}, {name: b, spec: " + inner + ", mass: a.r + a.mass}]\n")) ==
        "'a.r' is in m, but 'a.mass' is in kg (both sides of '+' must be in one unit)");
}

TEST_CASE("loops, local values and functions carry units") {
  const auto of_entry = [](const std::string& keys) {
    return OnlyFinding(Load(
        "mjforge: 1\nname: t\nparams: {w: {each: 1cm .. 2cm, count: 3}}\nfunctions: {f(a): a + "
        "1cm}\nparts: [{" +
        keys + ", name: 'a${i}', type: sphere}]\n"));
  };
  CHECK(of_entry("for: {i: 3}, size: i * 1cm + 1mm").empty());
  CHECK(of_entry("for: {i: 3}, size: i * 1kg") == "size is in m, but this is in kg");
  CHECK(of_entry("for: {i: 3cm}, size: 1") == "a loop's count is a plain number, but this is in m");
  CHECK(of_entry("for: {i: w}, size: i").empty());
  CHECK(of_entry("for: {i: w}, size: 1, mass: i") == "mass is in kg, but this is in m");
  CHECK(of_entry("for: {i: 3}, let: {gap: 1cm .. 2cm}, size: gap").empty());
  CHECK(of_entry("for: {i: 3}, let: {gap: 1cm .. 2cm}, size: 1, mass: gap") ==
        "mass is in kg, but this is in m");
  CHECK(of_entry("for: {i: 3}, size: f(i)").empty());
  const Loaded called = Load(
      "mjforge: 1\nname: t\nfunctions: {f(a): a + 1cm}\n"
      "parts: [{name: a, type: sphere, size: f(3kg)}]\n");
  REQUIRE(called.findings.size() == 1);
  const diag::Finding& finding = *called.findings.begin();
  CHECK(finding.mark.line == 3);
  CHECK(finding.message == "'a' is in kg, but '1cm' is in m");
  REQUIRE(finding.notes.size() == 1);
  CHECK(finding.notes[0].mark.line == 4);
}

TEST_CASE("a table's columns are in the units of its header") {
  const harness::TemporaryFolder folder;
  folder.Write("sizes.csv", "size,d [mm],rho [kg/m^3]\nM3,3,7850\nM4,4,2700\n");
  const auto of_part = [&](const std::string& keys) {
    return OnlyFinding(
        Load("mjforge: 1\nname: t\nparams: {t: {rows: " + (folder / "sizes.csv").string() +
             "}}\nparts: [{name: a, type: sphere, " + keys + "}]\n"));
  };
  CHECK(of_part("size: t.d, density: t.rho").empty());
  CHECK(of_part("size: t.rho") == "size is in m, but this is in kg/m^3");
  CHECK(of_part("size: 1, mass: t.d") == "mass is in kg, but this is in m");
  CHECK(of_part("size: 1, mass: t.rho * t.d ^ 3").empty());
}

TEST_CASE("a range within an expression is told to be drawn by itself") {
  CHECK(Load("mjforge: 1\nname: t\nparams: {a: (0 .. 1) * 2}\n"
             "parts: [{name: a, type: sphere, size: 1}]\n")
            .Report() ==
        Strings{"3:16 expr/syntax: a range cannot be part of an expression (draw it as a separate "
                "parameter and use that parameter's name)"});
}

TEST_CASE("who writes degrees where rad are meant is told") {
  const auto report = ReportWithBox("cameras: [{name: c, fovy: 60}]\n");
  REQUIRE(report.size() == 1);
  CHECK(report.front().ends_with("(angles are in rad: write 60deg)"));
}

}  // namespace
}  // namespace mjforge::spec
